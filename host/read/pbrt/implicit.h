#pragma once
// The shape "implicit": an expression and a box. Not of pbrt-v4: docs/implicit.md.

#include "read/pbrt/arguments.h"

namespace eikonal::pbrt {

/// Throws SceneError for an expression that is none, with the column in it, and for bounds that are no box.
ImplicitSurface readImplicit(const Arguments& arguments);

}  // namespace eikonal::pbrt
