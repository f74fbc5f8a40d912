#pragma once
// A function of x, y and z that was written as an expression: "x^2 + y^2 - z^3". Grammar: docs/implicit.md.

#include "error.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace eikonal {

enum class Operation {
    number, x, y, z,
    negate, add, subtract, multiply, divide, power,
    sqrt, abs, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log, min, max, atan2
};

/// One operation and what it is applied to.
struct ExpressionNode {
    Operation operation;
    double number = 0;   ///< Operation::number
    int a = -1, b = -1;  ///< operands, earlier in Expression::nodes; -1: none
};

/// Operands come before what is made of them; nothing is there twice, and what is made of numbers alone is one number, which is finite.
struct Expression {
    std::vector<ExpressionNode> nodes;   ///< the last one is the whole
};

/// Reads an expression. `where` is the place of its first character: errors, which are SceneErrors, name the column in the expression.
/// `constants` are names besides x, y, z and pi, and what they stand for. An expression that does not depend on x, y or z is an error.
Expression readExpression(std::string_view text, const SourceLocation& where, const std::map<std::string, double>& constants = {});

/// More operations are refused.
constexpr size_t mostOperations = 1000;

}  // namespace eikonal
