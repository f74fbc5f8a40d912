#include "read/formats/expression.h"

#include "printable.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <tuple>

namespace eikonal {
namespace {

struct Function { const char* name; Operation operation; int arguments; };

constexpr Function functions[] = {
    {"sqrt", Operation::sqrt, 1}, {"abs", Operation::abs, 1},   {"sin", Operation::sin, 1},   {"cos", Operation::cos, 1},   {"tan", Operation::tan, 1},
    {"asin", Operation::asin, 1}, {"acos", Operation::acos, 1}, {"atan", Operation::atan, 1}, {"sinh", Operation::sinh, 1}, {"cosh", Operation::cosh, 1},
    {"tanh", Operation::tanh, 1}, {"exp", Operation::exp, 1},   {"log", Operation::log, 1},   {"min", Operation::min, 2},   {"max", Operation::max, 2},
    {"pow", Operation::power, 2}, {"atan2", Operation::atan2, 2},
};

/// The limit on nested parentheses, signs and powers.
constexpr int mostLevels = 200;

double valueOf(Operation operation, double a, double b) {
    switch (operation) {
        case Operation::negate: return -a;
        case Operation::add: return a + b;
        case Operation::subtract: return a - b;
        case Operation::multiply: return a * b;
        case Operation::divide: return a / b;
        case Operation::power: return std::pow(a, b);
        case Operation::sqrt: return std::sqrt(a);
        case Operation::abs: return std::abs(a);
        case Operation::sin: return std::sin(a);
        case Operation::cos: return std::cos(a);
        case Operation::tan: return std::tan(a);
        case Operation::asin: return std::asin(a);
        case Operation::acos: return std::acos(a);
        case Operation::atan: return std::atan(a);
        case Operation::sinh: return std::sinh(a);
        case Operation::cosh: return std::cosh(a);
        case Operation::tanh: return std::tanh(a);
        case Operation::exp: return std::exp(a);
        case Operation::log: return std::log(a);
        case Operation::min: return std::min(a, b);
        case Operation::max: return std::max(a, b);
        case Operation::atan2: return std::atan2(a, b);
        default: return 0;   // leaves have no operands
    }
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

class ExpressionReader {
public:
    ExpressionReader(std::string_view text, const SourceLocation& where, const std::map<std::string, double>& constants)
        : text_(text), where_(where), constants_(constants) {}

    Expression read() {
        const int whole = readSum();
        skipBlanks();
        if (at_ < text_.size()) {
            const bool factor = isLetter(text_[at_]) || isDigit(text_[at_]) || text_[at_] == '(' || text_[at_] == '.';
            fail(at_, found() + " where an operator, one of + - * / ^, is expected" + (factor ? "; a product is written with *, as in 2*x" : text_[at_] == ')' ? "; there is no matching (" : ""));
        }
        if (isNumber(whole)) fail(0, "this is constant: F must depend on x, y or z");
        expression_.nodes.resize(static_cast<size_t>(whole) + 1);   // operands that were folded may follow it
        return std::move(expression_);
    }

private:
    [[noreturn]] void fail(size_t at, const std::string& message) const {
        SourceLocation place = where_;
        place.column += static_cast<int>(at);
        throw SceneError(place, "F: " + message);
    }

    void skipBlanks() { while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_; }
    char peek() { skipBlanks(); return at_ < text_.size() ? text_[at_] : '\0'; }
    bool take(char c) {
        if (peek() != c || at_ >= text_.size()) return false;
        ++at_;
        return true;
    }
    /// A description of the next token, for messages.
    std::string found() {
        skipBlanks();
        if (at_ >= text_.size()) return "the expression ends";
        size_t end = at_ + 1;
        const auto isPart = [](char c) { return isLetter(c) || isDigit(c) || c == '.'; };
        if (isPart(text_[at_])) while (end < text_.size() && isPart(text_[end])) ++end;
        return "\"" + printable(std::string(text_.substr(at_, std::min(end - at_, size_t(40))))) + "\" found";
    }

    bool isNumber(int node) const { return expression_.nodes[static_cast<size_t>(node)].operation == Operation::number; }
    double number(int node) const { return expression_.nodes[static_cast<size_t>(node)].number; }

    /// `at`: the place to report if the number is not finite or too large.
    int add(const ExpressionNode& node, size_t at) {
        if (node.operation == Operation::number && !(std::abs(node.number) < 1e35))
            fail(at, std::isfinite(node.number) ? "this is a number above 1e35, too large to compute with" : "this is not a number: it is infinite, or undefined");
        const auto [place, isNew] = known_.try_emplace({node.operation, node.number, node.a, node.b}, static_cast<int>(expression_.nodes.size()));
        if (!isNew) return place->second;
        if (expression_.nodes.size() >= mostOperations) fail(at, "the expression is too long: it may have " + std::to_string(mostOperations) + " different operations and numbers");
        expression_.nodes.push_back(node);
        return place->second;
    }
    int apply(Operation operation, size_t at, int a, int b = -1) {
        if (isNumber(a) && (b < 0 || isNumber(b))) return add({Operation::number, valueOf(operation, number(a), b < 0 ? 0 : number(b))}, at);
        return add({operation, 0, a, b}, at);
    }

    int readSum() {
        int sum = readProduct();
        while (true) {
            const char c = peek();
            const size_t at = at_;
            if (!take('+') && !take('-')) return sum;
            const int next = readProduct();
            sum = apply(c == '+' ? Operation::add : Operation::subtract, at, sum, next);
        }
    }
    int readProduct() {
        int product = readSigned();
        while (true) {
            const char c = peek();
            const size_t at = at_;
            if (!take('*') && !take('/')) return product;
            const int next = readSigned();
            product = apply(c == '*' ? Operation::multiply : Operation::divide, at, product, next);
        }
    }
    int readSigned() {
        const Level level(*this);
        skipBlanks();
        const size_t at = at_;
        if (take('-')) return apply(Operation::negate, at, readSigned());
        if (take('+')) return readSigned();
        return readPower();
    }
    int readPower() {
        const int base = readPrimary();
        skipBlanks();
        const size_t at = at_;
        return take('^') ? apply(Operation::power, at, base, readSigned()) : base;
    }

    int readPrimary() {
        const char c = peek();
        if (isDigit(c) || c == '.') return readNumber();
        if (isLetter(c)) return readName();
        const size_t open = at_;
        if (take('(')) {
            const int inner = readSum();
            if (!take(')')) fail(at_, found() + " where the ) of the ( in column " + std::to_string(where_.column + static_cast<int>(open)) + " is expected");
            return inner;
        }
        fail(at_, found() + " where a number, x, y, z, a function or ( is expected");
    }

    int readNumber() {
        const size_t at = at_;
        double value = 0;
        const auto [stop, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (error == std::errc::invalid_argument) fail(at, found() + " where a number is expected");
        at_ = static_cast<size_t>(stop - text_.data());
        if (error == std::errc::result_out_of_range) {
            /* The number underflows or overflows */
            const std::string_view digits = text_.substr(at, at_ - at);
            const size_t exponent = digits.find_first_of("eE");
            value = exponent != digits.npos && exponent + 1 < digits.size() && digits[exponent + 1] == '-' ? 0 : HUGE_VAL;
        }
        return add({Operation::number, value}, at);
    }

    int readName() {
        const size_t at = at_;
        while (at_ < text_.size() && (isLetter(text_[at_]) || isDigit(text_[at_]))) ++at_;
        const std::string name(text_.substr(at, at_ - at));
        for (const Function& f : functions)
            if (name == f.name) return readCall(f, at);
        if (name == "x") return add({Operation::x}, at);
        if (name == "y") return add({Operation::y}, at);
        if (name == "z") return add({Operation::z}, at);
        if (name == "pi") return add({Operation::number, M_PI}, at);
        const auto constant = constants_.find(name);
        if (constant != constants_.end()) return add({Operation::number, constant->second}, at);
        failUnknown(name, at);
    }

    [[noreturn]] void failUnknown(const std::string& name, size_t at) {
        std::vector<std::string> names{"x", "y", "z", "pi"};
        for (const auto& [constant, value] : constants_) names.push_back(constant);
        std::string known;
        for (const std::string& n : names) known += (known.empty() ? "" : ", ") + n;
        known += "; the functions";
        for (const Function& f : functions) {
            names.push_back(f.name);
            known += std::string(" ") + f.name;
        }
        const std::string near = name.size() > 1 ? nearestWord(name, names) : "";
        const bool constant = name.size() == 1 && name[0] >= 'a' && name[0] <= 'd';
        fail(at, "there is no \"" + printable(name.substr(0, 40)) + "\"" + (near.empty() ? constant ? ": give it with \"float " + name + "\"" : "; known are " + known : "; did you mean \"" + near + "\"?"));
    }

    int readCall(const Function& f, size_t at) {
        const Level level(*this);
        const std::string name = f.name, usage = name + (f.arguments == 2 ? "(..., ...)" : "(...)");
        if (!take('(')) fail(at_, found() + " where ( is expected: " + usage);
        const int a = readSum();
        int b = -1;
        if (f.arguments == 2) {
            if (!take(',')) fail(at_, found() + " where a comma is expected: " + usage);
            b = readSum();
        }
        if (!take(')')) fail(at_, found() + " where ) is expected: " + usage);
        return apply(f.operation, at, a, b);
    }

    /// Counts a level of nesting.
    struct Level {
        explicit Level(ExpressionReader& reader) : levels(reader.levels_) {
            if (++levels > mostLevels) reader.fail(reader.at_, "the expression is nested too deeply here: at most " + std::to_string(mostLevels) + " levels are possible");
        }
        ~Level() { --levels; }
        int& levels;
    };

    std::string_view text_;
    SourceLocation where_;
    const std::map<std::string, double>& constants_;
    size_t at_ = 0;
    int levels_ = 0;
    Expression expression_;
    std::map<std::tuple<Operation, double, int, int>, int> known_;
};

}  // namespace

Expression readExpression(std::string_view text, const SourceLocation& where, const std::map<std::string, double>& constants) {
    return ExpressionReader(text, where, constants).read();
}

}  // namespace eikonal
