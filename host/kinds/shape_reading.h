#pragma once
// Shared code for reading shapes from a pbrt scene.

#include "kinds/shape_kind.h"
#include "read/pbrt/meshes.h"
#include "read/pbrt/shapes.h"

namespace eikonal::pbrt {

/// The input of a shape's `read`.
struct ShapeReading {
    Reading& reading;
    const Arguments& arguments;
    PlyFiles& plyFiles;
};

/// Returns hasArea; if false, warns that the shape is skipped.
bool keepIf(bool hasArea, const ShapeReading& in);

}  // namespace eikonal::pbrt
