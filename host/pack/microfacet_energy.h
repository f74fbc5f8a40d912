#pragma once
// Tables of the light that microfacets lose because they scatter it once (include/eikonal/microfacet_energy.h).

#include "pack/tables.h"

#include <map>
#include <optional>
#include <tuple>

namespace eikonal {

/// A surface of GGX microfacets. No width: it varies; isotropic: y is x.
struct MicrofacetSurface {
    std::optional<double> alphaX, alphaY;
    bool isotropic = true;
    /// The range of a dielectric's index, inside over outside; 0: a surface that reflects all light.
    double lowestIndex = 0, highestIndex = 0;
    auto key() const { return std::tuple(alphaX, alphaY, isotropic, lowestIndex, highestIndex); }
};

class MicrofacetEnergyPacker {
public:
    MicrofacetEnergyPacker(BsdfTables& tables, SceneConstants& constants) : tables_(tables), constants_(constants) {}

    /// The index in `energy_tables` of a surface.
    uint table(const MicrofacetSurface& surface);

private:
    BsdfTables& tables_;
    SceneConstants& constants_;
    std::map<decltype(MicrofacetSurface{}.key()), uint> tablesOf_;
};

}  // namespace eikonal
