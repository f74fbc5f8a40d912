#include "pack/implicit.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace eikonal {
namespace {

/// Values beyond this count as infinite on the device (kernels/shape/wide_range.clh).
constexpr double largest = 1e37;
/// The largest integer exponent that is raised by multiplication, whose roundings then change the power by at most a quarter.
constexpr double largestIntegerPower = 1 << 21;

/// An instruction before register allocation: values are numbered, beginning with x, y and z.
struct Step { implicit_operation operation; int a = -1, b = -1; double number = 0; unsigned exponent = 0; };
constexpr int coordinates = 3;

/// Lowers an expression to the operations of the device.
class Lowering {
public:
    explicit Lowering(const Expression& expression) : expression_(expression), values_(expression.nodes.size(), -1) {
        const size_t whole = expression.nodes.size() - 1;
        std::vector<char> needed(whole + 1, 0);
        needed[whole] = 1;
        for (size_t i = whole + 1; i-- > 0;) {
            const ExpressionNode& n = expression.nodes[i];
            for (const int operand : {n.a, n.b})
                if (needed[i] && operand >= 0) needed[static_cast<size_t>(operand)] = 1;
        }
        for (size_t i = 0; i <= whole; ++i)
            if (needed[i] && expression.nodes[i].operation != Operation::number) values_[i] = lower(expression.nodes[i]);
        /* The last instruction must compute the whole expression, even if it is just a coordinate */
        if (values_[whole] < coordinates) scale(values_[whole], 1);
    }
    const std::vector<Step>& steps() const { return steps_; }

private:
    std::optional<double> constant(int node) const {
        const ExpressionNode& n = expression_.nodes[static_cast<size_t>(node)];
        return n.operation == Operation::number ? std::optional(n.number) : std::nullopt;
    }
    int value(int node) {
        int& known = values_[static_cast<size_t>(node)];
        if (known < 0) known = step({implicit_number, -1, -1, *constant(node)});
        return known;
    }

    int step(const Step& s) {
        for (size_t i = 0; i < steps_.size(); ++i) {
            const Step& t = steps_[i];
            if (t.operation == s.operation && t.a == s.a && t.b == s.b && t.number == s.number && t.exponent == s.exponent)
                return coordinates + static_cast<int>(i);
        }
        steps_.push_back(s);
        return coordinates + static_cast<int>(steps_.size()) - 1;
    }
    int unary(implicit_operation operation, int a) { return step({operation, a}); }
    int binary(implicit_operation operation, int a, int b) { return step({operation, a, b}); }
    int shift(int a, double by) { return step({implicit_shift, a, -1, by}); }
    int scale(int a, double by) { return step({implicit_scale, a, -1, by}); }
    int multiply(int a, int b) { return a == b ? unary(implicit_square, a) : binary(implicit_multiply, a, b); }
    int divide(int a, int b) { return multiply(a, unary(implicit_reciprocal, b)); }
    int sine(int a) { return unary(implicit_sine, a); }
    int cosine(int a) { return sine(shift(a, M_PI / 2)); }

    int raise(int a, double exponent) {
        if (exponent == 0) return step({implicit_number, -1, -1, 1});
        if (exponent < 0) return unary(implicit_reciprocal, raise(a, -exponent));
        if (exponent == 1) return a;
        if (exponent == 2) return unary(implicit_square, a);
        if (exponent == 0.5) return unary(implicit_sqrt, a);
        if (exponent == std::floor(exponent) && exponent <= largestIntegerPower)
            return step({implicit_integer_power, a, -1, 0, static_cast<unsigned>(exponent)});
        return step({implicit_power, a, -1, exponent});
    }

    int lower(const ExpressionNode& n) {
        const std::optional<double> ca = n.a >= 0 ? constant(n.a) : std::nullopt, cb = n.b >= 0 ? constant(n.b) : std::nullopt;
        switch (n.operation) {
            case Operation::number: break;
            case Operation::x: return 0;
            case Operation::y: return 1;
            case Operation::z: return 2;
            case Operation::negate: return scale(value(n.a), -1);
            case Operation::add:
                return ca ? shift(value(n.b), *ca) : cb ? shift(value(n.a), *cb) : binary(implicit_add, value(n.a), value(n.b));
            case Operation::subtract:
                if (ca) return shift(scale(value(n.b), -1), *ca);
                return cb ? shift(value(n.a), -*cb) : binary(implicit_subtract, value(n.a), value(n.b));
            case Operation::multiply: return ca ? scale(value(n.b), *ca) : cb ? scale(value(n.a), *cb) : multiply(value(n.a), value(n.b));
            case Operation::divide:
                if (cb && *cb != 0 && std::abs(1 / *cb) < largest) return scale(value(n.a), 1 / *cb);
                if (ca) return scale(unary(implicit_reciprocal, value(n.b)), *ca);
                return divide(value(n.a), value(n.b));
            case Operation::power:
                return cb ? raise(value(n.a), *cb) : unary(implicit_exp, multiply(value(n.b), unary(implicit_log, value(n.a))));
            case Operation::sqrt: return unary(implicit_sqrt, value(n.a));
            case Operation::abs: return unary(implicit_abs, value(n.a));
            case Operation::sin: return sine(value(n.a));
            case Operation::cos: return cosine(value(n.a));
            case Operation::tan: return divide(sine(value(n.a)), cosine(value(n.a)));
            case Operation::asin: return unary(implicit_asin, value(n.a));
            case Operation::acos: return shift(scale(unary(implicit_asin, value(n.a)), -1), M_PI / 2);
            case Operation::atan: return unary(implicit_atan, value(n.a));
            case Operation::sinh:
                return scale(binary(implicit_subtract, unary(implicit_exp, value(n.a)), unary(implicit_exp, scale(value(n.a), -1))), 0.5);
            case Operation::cosh:
                return scale(binary(implicit_add, unary(implicit_exp, value(n.a)), unary(implicit_exp, scale(value(n.a), -1))), 0.5);
            /* 1 - 2 / (e^2a + 1) contains its operand once, so interval arithmetic is tight */
            case Operation::tanh:
                return shift(scale(unary(implicit_reciprocal, shift(unary(implicit_exp, scale(value(n.a), 2)), 1)), -2), 1);
            case Operation::exp: return unary(implicit_exp, value(n.a));
            case Operation::log: return unary(implicit_log, value(n.a));
            case Operation::min: return binary(implicit_min, value(n.a), value(n.b));
            case Operation::max: return binary(implicit_max, value(n.a), value(n.b));
            case Operation::atan2: return binary(implicit_atan2, value(n.a), value(n.b));
        }
        return -1;
    }

    const Expression& expression_;
    std::vector<int> values_;   ///< of the expression's nodes; -1: not made (yet)
    std::vector<Step> steps_;
};

}  // namespace

std::vector<implicit_instruction> implicitProgram(const Expression& expression, const SourceLocation& where) {
    const Lowering lowered(expression);
    const std::vector<Step>& steps = lowered.steps();
    std::vector<size_t> lastUse(steps.size(), 0);
    for (size_t i = 0; i < steps.size(); ++i)
        for (const int operand : {steps[i].a, steps[i].b})
            if (operand >= coordinates) lastUse[static_cast<size_t>(operand - coordinates)] = i;

    std::vector<implicit_instruction> program;
    std::vector<uint> registers(steps.size()), unused;
    for (uint r = IMPLICIT_REGISTERS; r-- > coordinates;) unused.push_back(r);
    const auto registerOf = [&](int operand) {
        return operand < 0             ? 0u
               : operand < coordinates ? static_cast<uint>(operand)
                                       : registers[static_cast<size_t>(operand - coordinates)];
    };
    for (size_t i = 0; i < steps.size(); ++i) {
        const Step& s = steps[i];
        implicit_instruction instruction{static_cast<uint>(s.operation), 0, registerOf(s.a), registerOf(s.b),
                                         static_cast<float>(s.number),   0};
        const double exponent = s.operation == implicit_integer_power ? s.exponent : s.number;
        if (s.operation == implicit_integer_power) instruction.b = s.exponent;
        if (s.operation == implicit_integer_power || s.operation == implicit_power)
            instruction.limit = static_cast<float>(std::min(std::pow(largest, 1 / exponent), largest));
        /* A register is free after its last use; operands are read before the target is written */
        for (const int operand : {s.a, s.a == s.b ? -1 : s.b})
            if (operand >= coordinates && lastUse[static_cast<size_t>(operand - coordinates)] == i) unused.push_back(registerOf(operand));
        if (unused.empty())
            throw SceneError(where, "F has more than " + std::to_string(IMPLICIT_REGISTERS - coordinates) +
                                        " intermediate results that are needed later: too many to keep. "
                                        "Sums that are taken term by term, a + b + c, need fewer than nested ones, a + (b + (c + d)).");
        instruction.target = registers[i] = unused.back();
        unused.pop_back();
        program.push_back(instruction);
    }
    return program;
}

}  // namespace eikonal
