#pragma once
// What kinds of materials read of a pbrt scene, besides their inputs.

#include "kinds/material_kind.h"
#include "read/pbrt/arguments.h"
#include "read/pbrt/materials.h"
#include "read/pbrt/textures.h"

namespace eikonal::pbrt {

/// What there is to read a material from.
struct MaterialReading {
    Reading& reading;
    const Arguments& arguments;
    TextureRegistry& textures;
    MaterialRegistry& materials;   ///< where others are found by their names
};

}  // namespace eikonal::pbrt
