#pragma once
// The shape "implicit": an expression and a box. An extension of pbrt-v4: docs/implicit.md.

#include "read/pbrt/arguments.h"

namespace eikonal::pbrt {

/// Throws SceneError for an invalid expression, with the column in it, and for invalid bounds.
ImplicitSurface readImplicit(Reading& reading, const Arguments& arguments);

}  // namespace eikonal::pbrt
