#pragma once
// Compiles an expression to the program that kernels/shape/implicit_program.clh runs.

#include "eikonal/shape.h"
#include "read/formats/expression.h"

#include <vector>

namespace eikonal {

/// The instructions of an expression; the target of the last one holds its value. Throws SceneError if they need too many registers.
std::vector<implicit_instruction> implicitProgram(const Expression&, const SourceLocation& where);

}  // namespace eikonal
