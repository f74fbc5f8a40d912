#pragma once
// Every kind of material: one file of host/kinds/material/ for each line of MATERIALS
// (include/eikonal/materials.h), which holds all that the host knows of it. What it
// scatters is a BSDF of BSDFS (include/eikonal/bsdfs.h): a smooth material may have another than a rough one.

#include "eikonal/materials.h"
#include "eikonal/stages.h"

#include <array>
#include <span>

namespace eikonal {

class InputWriter;
struct Material;
namespace pbrt { struct MaterialReading; }

/// A material `Material "name"` of a pbrt scene, and its parameters as a row of read/pbrt/kinds.h. "-> name" gives a parameter another name
/// in the scene; "-> -" leaves it out of Material::inputs.
struct MaterialDirective { const char *name, *parameters; };

/// What a kind's file defines.
struct MaterialKind {
    std::span<const MaterialDirective> directives;
    /// Fills in what is more than an input. Throws SceneError. Null: there is no more.
    void (*read)(const pbrt::MaterialReading&, Material&) = nullptr;
    /// Writes the parameters of its BSDF, and says which it is.
    next_queue (*pack)(InputWriter&) = nullptr;
    /// The inputs that are a metal's index of refraction and its absorption, of which "reflectance" takes the place. Null: none.
    std::array<const char*, 2> metalIndices{};
};

/* Each kind's file defines one of them. */
#define DECLARE_KIND(name) extern const MaterialKind name##_material;
MATERIALS(DECLARE_KIND)
#undef DECLARE_KIND

/// All kinds, in the order of MATERIALS.
std::span<const MaterialKind* const> materialKindList();

}  // namespace eikonal
