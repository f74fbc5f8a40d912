#pragma once
// Curves as pbrt-v4 writes them: Bezier curves and uniform B-splines of degree 2 and 3.

#include "read/pbrt/arguments.h"

namespace eikonal::pbrt {

/// The segments of a shape "curve". Throws SceneError: an unknown basis or degree, a number of control points or normals that
/// does not fit.
std::shared_ptr<Curve> readCurve(Reading& reading, const Arguments& arguments);

}  // namespace eikonal::pbrt
