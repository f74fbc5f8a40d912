#pragma once
// Functions of x, y and z written as expressions, such as "x^2 + y^2 - z^3". Grammar: docs/implicit.md.

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

/// An operation and its operands.
struct ExpressionNode {
    Operation operation;
    double number = 0;   ///< Operation::number
    int a = -1, b = -1;  ///< operands: indices of earlier nodes; -1: none
};

/// Operands come before their operation. Nodes are unique, and subexpressions of numbers are folded into one finite number.
struct Expression {
    std::vector<ExpressionNode> nodes;   ///< the last one is the whole expression
};

/// Parses an expression. `where` is the place of its first character; errors are SceneErrors that name the column in the expression.
/// `constants`: names besides x, y, z and pi, with their values. An expression that does not depend on x, y or z is an error.
Expression readExpression(std::string_view text, const SourceLocation& where, const std::map<std::string, double>& constants = {});

/// The most operations in an expression.
constexpr size_t mostOperations = 1000;

}  // namespace eikonal
