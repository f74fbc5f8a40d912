#pragma once
// From an expression to the program that kernels/shape/implicit_program.clh runs.

#include "eikonal/shape.h"
#include "read/formats/expression.h"

#include <vector>

namespace eikonal {

/// The instructions of an expression; the last one's target holds its value. Throws SceneError if they need more registers than there are.
std::vector<implicit_instruction> implicitProgram(const Expression&, const SourceLocation& where);

}  // namespace eikonal
