#pragma once
// What kinds of shapes read of a pbrt scene.

#include "kinds/shape_kind.h"
#include "read/pbrt/meshes.h"
#include "read/pbrt/shapes.h"

namespace eikonal::pbrt {

/// What there is to read a shape from.
struct ShapeReading {
    Reading& reading;
    const Arguments& arguments;
    PlyFiles& plyFiles;
};

/// "phimax" in [0, 360].
double phiMaxOf(const Arguments& arguments);

/// Returns hasArea, after a warning that the shape is left out if it has none.
bool keepIf(bool hasArea, const ShapeReading& in);

}  // namespace eikonal::pbrt
