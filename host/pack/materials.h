#pragma once
// Materials: BSDF inputs, interior, bump and normal maps.

#include "eikonal/stages.h"
#include "pack/material_inputs.h"
#include "pack/media.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace eikonal {

/// A material before it is packed.
constexpr material blankMaterial{next_none, 0, 0, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, 0, 0, 0, 0};

/// Packs only the materials that are used, so that no stage runs without need.
class MaterialPacker {
public:
    MaterialPacker(const MaterialPacking& in, MediumPacker& media)
        : in_(in), media_(media), indices_(in.context.scene.materials.size(), NONE) {}

    /// The index in `materials` of a material of the scene, or of pbrt's default material.
    uint material(int index);

    /// Whether rays may pass through the material at that index in `materials` to the other side of a closed surface.
    bool isEntered(uint index) const { return entered_.contains(index); }

    /// By index in `materials`: the scene's material that the packed one stands for; none: pbrt's default, or a part of another.
    std::vector<int> sources() const;

    const MaterialTables& tables() const { return in_.tables; }

private:
    using PackedMaterial = eikonal::material;
    void pack(const Material& description, PackedMaterial& m, bool regularize = false);
    void packInside(InputWriter& inputs, const Material& description, PackedMaterial& m);
    uint profile(InputWriter& inputs, const Material& description);
    const DiffusionProfile& profileOf(const Material& body) const;
    Material coatOver(const Material& body) const;
    void warnOfPoints() const;
    void requireBsdf(next_queue h, const std::string& why) const;

    const MaterialPacking in_;
    MediumPacker& media_;
    std::vector<uint> indices_;                         ///< scene materials -> `materials`
    std::set<uint> entered_;                            ///< indices in `materials`
    std::map<const DiffusionProfile*, uint> profiles_;  ///< -> `profiles`
    uint default_ = NONE;
};

}  // namespace eikonal
