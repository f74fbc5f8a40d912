#pragma once
// Reads curves as in pbrt-v4: Bezier curves and uniform B-splines of degree 2 and 3.

#include "read/pbrt/arguments.h"

namespace eikonal::pbrt {

/// The segments of a shape "curve". Throws SceneError for an unknown basis or degree, or a wrong number of control points or normals.
std::shared_ptr<Curve> readCurve(Reading& reading, const Arguments& arguments);

}  // namespace eikonal::pbrt
