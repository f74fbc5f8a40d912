// Expressions: what they mean, and what is said about those that mean nothing.

#include "read/formats/expression.h"

#include "pack/implicit.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace eikonal {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const SourceLocation start{std::make_shared<const std::string>("test.pbrt"), 3, 20};

/// The value of an expression of x, y, z; functions of numbers alone have become numbers.
double valueOf(const Expression& e, int node, const double (&p)[3]) {
    const ExpressionNode& n = e.nodes[static_cast<size_t>(node)];
    const double a = n.a < 0 ? 0 : valueOf(e, n.a, p), b = n.b < 0 ? 0 : valueOf(e, n.b, p);
    switch (n.operation) {
        case Operation::number: return n.number;
        case Operation::x: return p[0];
        case Operation::y: return p[1];
        case Operation::z: return p[2];
        case Operation::negate: return -a;
        case Operation::add: return a + b;
        case Operation::subtract: return a - b;
        case Operation::multiply: return a * b;
        case Operation::divide: return a / b;
        case Operation::power: return std::pow(a, b);
        default: ADD_FAILURE() << "a function"; return 0;
    }
}
double at(const std::string& text, double x, double y = 0, double z = 0) {
    const Expression e = readExpression(text, start, {{"a", 7}, {"b", -2}});
    return valueOf(e, static_cast<int>(e.nodes.size()) - 1, {x, y, z});
}
/// The number that an expression of numbers is.
double number(const std::string& text) { return at("x + (" + text + ")", 0); }

std::string errorOf(const std::string& text) {
    try {
        implicitProgram(readExpression(text, start), start);
        return "no error";
    } catch (const SceneError& error) { return error.what(); }
}

TEST(Expressions, BindAsInMathematics) {
    EXPECT_EQ(number("2 + 3 * 4"), 14);
    EXPECT_EQ(number("2 - 3 - 4"), -5);
    EXPECT_EQ(number("24 / 4 / 2"), 3);
    EXPECT_EQ(number("2 ^ 3 ^ 2"), 512);
    EXPECT_EQ(number("-2 ^ 2"), -4);
    EXPECT_EQ(number("2 ^ -2"), 0.25);
    EXPECT_EQ(number("-2 * -3"), 6);
    EXPECT_EQ(number("--2 - +1"), 1);
    EXPECT_EQ(number("(2 + 3) * 4"), 20);
    EXPECT_EQ(at("-x^2 + y*z", 3, 5, 2), 1);
    EXPECT_EQ(at("x/y/z", 12, 3, 2), 2);
    EXPECT_EQ(at("a*x - b", 3), 23);
    EXPECT_DOUBLE_EQ(at("x^.5", 16), 4);
}

TEST(Expressions, HaveTheFunctionsOfTheDocument) {
    const std::pair<const char*, double> functions[] = {
        {"sqrt(2)", std::sqrt(2.)}, {"abs(-3)", 3}, {"sin(1)", std::sin(1.)}, {"cos(1)", std::cos(1.)}, {"tan(1)", std::tan(1.)}, {"asin(.5)", std::asin(.5)}, {"acos(.5)", std::acos(.5)},
        {"atan(2)", std::atan(2.)}, {"sinh(1)", std::sinh(1.)}, {"cosh(1)", std::cosh(1.)}, {"tanh(1)", std::tanh(1.)}, {"exp(1)", std::exp(1.)}, {"log(2)", std::log(2.)},
        {"min(2, 3)", 2}, {"max(2, 3)", 3}, {"pow(2, 3)", 8}, {"atan2(1, -1)", std::atan2(1., -1.)}, {"pi", M_PI}, {"1.5e-3", 1.5e-3}, {".5", .5}, {"2.", 2}, {"1e-400", 0}};
    for (const auto& [text, value] : functions) EXPECT_DOUBLE_EQ(number(text), value) << text;
}

/// What is written twice is computed once, and numbers are put together.
TEST(Expressions, AreShort) {
    EXPECT_EQ(implicitProgram(readExpression("(x^2 + y^2 - 2*3)*(y*0.5/.25) + (x^2 + y^2 - 6)", start), start).size(), 8u);
    EXPECT_EQ(implicitProgram(readExpression("x*x - 1", start), start).front().operation, static_cast<uint>(implicit_square));
    EXPECT_EQ(implicitProgram(readExpression("z", start), start).size(), 1u);
}

/// The column is that of the text "F" in the file: it starts at 20.
TEST(Expressions, SayWhatIsWrongWhereItIs) {
    const std::pair<const char*, const char*> errors[] = {
        {"", "test.pbrt:3:20: F: the expression ends where a number, x, y, z, a function or ( is expected"},
        {"x +", "test.pbrt:3:23: F: the expression ends where a number"},
        {"x + * y", "test.pbrt:3:24: F: \"*\" found where a number"},
        {"2x", "test.pbrt:3:21: F: \"x\" found where an operator, one of + - * / ^, is expected; a product is written with *, as in 2*x"},
        {"x + (y - 1", "test.pbrt:3:30: F: the expression ends where the ) of the ( in column 24 is expected"},
        {"x)", "test.pbrt:3:21: F: \")\" found where an operator, one of + - * / ^, is expected; there is no matching ("},
        {"x + sim(y)", "test.pbrt:3:24: F: there is no \"sim\"; did you mean \"sin\"?"},
        {"x + w", "test.pbrt:3:24: F: there is no \"w\"; known are x, y, z, pi; the functions sqrt abs sin"},
        {"x + a", "test.pbrt:3:24: F: there is no \"a\": give it with \"float a\""},
        {"sin x", "test.pbrt:3:24: F: \"x\" found where ( is expected: sin(...)"},
        {"atan2(x)", "test.pbrt:3:27: F: \")\" found where a comma is expected: atan2(..., ...)"},
        {"min(x, y, z)", "test.pbrt:3:28: F: \",\" found where ) is expected: min(..., ...)"},
        {"x + 1/0", "test.pbrt:3:25: F: this is not a number: it is infinite, or undefined"},
        {"x + sqrt(-1)", "test.pbrt:3:24: F: this is not a number"},
        {"x - 1e36", "test.pbrt:3:24: F: this is a number above 1e35"},
        {"x - 1e999", "test.pbrt:3:24: F: this is not a number"},
        {"2 + 3", "test.pbrt:3:20: F: this is constant"},
        {"x = 2", "test.pbrt:3:22: F: \"=\" found where an operator"},
        {"x ; system(\"rm\")", "test.pbrt:3:22: F: \";\" found where an operator"},
        {"x + .", "test.pbrt:3:24: F: \".\" found where a number is expected"},
        {"x \x1b[2J", "test.pbrt:3:22: F: \"\\x1b\" found"},
    };
    for (const auto& [text, message] : errors) EXPECT_THAT(errorOf(text), StartsWith(message)) << text;
}

TEST(Expressions, AreNotEndless) {
    const auto repeated = [](const std::string& text, int times) {
        std::string all;
        for (int i = 0; i < times; ++i) all += text;
        return all;
    };
    EXPECT_THAT(errorOf(repeated("(", 100000)), HasSubstr("at most 200 levels"));
    EXPECT_THAT(errorOf(repeated("-", 100000) + "x"), HasSubstr("at most 200 levels"));
    EXPECT_THAT(errorOf(repeated("2^", 100000) + "x"), HasSubstr("at most 200 levels"));
    EXPECT_THAT(errorOf(repeated("sin(", 100000)), HasSubstr("at most 200 levels"));
    std::string sum = "x", nested = "x";
    for (int i = 0; i < 2000; ++i) sum += " + x^" + std::to_string(i + 2);
    EXPECT_THAT(errorOf(sum), HasSubstr("the expression is too long: it may have 1000"));
    for (int i = 0; i < 40; ++i) nested = "x^" + std::to_string(i + 2) + "*y + (" + nested + ")*z";
    EXPECT_THAT(errorOf(nested), HasSubstr("intermediate results"));
}

/// Whatever is in the text, it is read or refused; instructions name registers that there are.
TEST(Expressions, GarbageIsRefusedOrUnderstood) {
    std::mt19937 random(7);
    const std::string alphabet[] = {"x", "y", "z", "+", "-", "*", "/", "^", "(", ")", ",", "1", "2.5", "1e3", ".", "e", " ", "sin(", "atan2(", "min(", "sqrt(", "pi", "\xff", "q", "1e-9", std::string(1, '\0')};
    int understood = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text;
        for (size_t length = 1 + random() % 12; length > 0; --length) text += alphabet[random() % std::size(alphabet)];
        try {
            const auto program = implicitProgram(readExpression(text, start), start);
            ++understood;
            for (const implicit_instruction& step : program) {
                ASSERT_LT(step.target, static_cast<uint>(IMPLICIT_REGISTERS));
                ASSERT_TRUE(step.a < IMPLICIT_REGISTERS && (step.b < IMPLICIT_REGISTERS || step.operation == implicit_integer_power)) << text;
                ASSERT_TRUE(std::isfinite(step.number)) << text;
            }
        } catch (const SceneError& error) { ASSERT_THAT(error.what(), StartsWith("test.pbrt:3:")) << text; }
    }
    EXPECT_GT(understood, 200);
}

}  // namespace
}  // namespace eikonal
