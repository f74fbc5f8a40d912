#pragma once
// Shared code for reading materials from a pbrt scene.

#include "kinds/material_kind.h"
#include "read/pbrt/arguments.h"
#include "read/pbrt/materials.h"
#include "read/pbrt/textures.h"

namespace eikonal::pbrt {

/// The input of a material's `read`.
struct MaterialReading {
    Reading& reading;
    const Arguments& arguments;
    TextureRegistry& textures;
    MaterialRegistry& materials;   ///< finds other materials by name
};

/// The `read` of rough surfaces that take "bool energycompensation".
inline void readEnergyCompensation(const MaterialReading& in, Material& material) {
    material.compensatesEnergy = in.arguments.flag("energycompensation");
}

}  // namespace eikonal::pbrt
