#pragma once
// The host's side of each kind of material: one file in host/kinds/material/ for each line of MATERIALS (include/eikonal/materials.h).
// A material is packed as one of the BSDFS (include/eikonal/bsdfs.h); smooth and rough variants may use different ones.

#include "eikonal/materials.h"
#include "eikonal/stages.h"

#include <array>
#include <span>

namespace eikonal {

class InputWriter;
struct Material;
namespace pbrt { struct MaterialReading; }

/// `Material "name"` in a pbrt scene, and its parameters as a row of read/pbrt/kinds.h. "-> name" renames a parameter in Material::inputs;
/// "-> -" leaves it out.
struct MaterialDirective { const char *name, *parameters; };

/// What a kind's file defines.
struct MaterialKind {
    std::span<const MaterialDirective> directives;
    /// Fills in the fields that are not inputs. Throws SceneError. Null: there are none.
    void (*read)(const pbrt::MaterialReading&, Material&) = nullptr;
    /// Writes the parameters of its BSDF, and returns that BSDF's queue.
    next_queue (*pack)(InputWriter&) = nullptr;
    /// The inputs for a conductor's eta and k, which "reflectance" replaces. Null: not a conductor.
    std::array<const char*, 2> metalIndices{};
    /// Whether it is a surface of its own, with a displacement and a normal map.
    bool isSurface = true;
    /// Whether light inside is followed by one of several methods (Material::method).
    bool hasMethods = false;
};

/* One for each kind, defined in the kind's file. */
#define DECLARE_KIND(name) extern const MaterialKind name##_material;
MATERIALS(DECLARE_KIND)
#undef DECLARE_KIND

/// All kinds, in the order of MATERIALS.
std::span<const MaterialKind* const> materialKindList();

}  // namespace eikonal
