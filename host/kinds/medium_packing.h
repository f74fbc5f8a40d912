#pragma once
// Shared code for packing media.

#include "kinds/medium_kind.h"
#include "pack/grids.h"
#include "pack/colors.h"

namespace eikonal {

/// What kinds of media write.
struct MediumPacking {
    const PackContext& context;
    MediumTables& tables;
    ColorPacker& colors;
};

/// A homogeneous medium with the coefficients, emission and phase function of a description.
medium newMedium(const MediumPacking&, const Medium&);

/// Heterogeneous media: sets the box with corners p0 and p1 in medium space. Returns the transform from the unit cube to medium space.
glm::dmat4 packBox(const MediumPacking&, const Medium&, glm::dvec3 p0, glm::dvec3 p1, medium& m);

/// Packs majorants on a grid of `cells`. bound(low, high) bounds the extinction in a box of the unit cube, before the factor that the
/// kernel applies to the medium's majorants (bounded_x_medium).
template <class Bound> void packMajorants(MediumTables& tables, medium& m, glm::ivec3 cells, const Bound& bound) {
    m.majorants_x = static_cast<uint>(cells.x);
    m.majorants_y = static_cast<uint>(cells.y);
    m.majorants_z = static_cast<uint>(cells.z);
    m.first_majorant = static_cast<uint>(tables.majorants.size());
    const glm::dvec3 size(cells);
    for (int z = 0; z < cells.z; ++z)
        for (int y = 0; y < cells.y; ++y)
            for (int x = 0; x < cells.x; ++x)
                tables.majorants.push_back(bound(glm::dvec3(x, y, z) / size, glm::dvec3(x + 1, y + 1, z + 1) / size));
}
/// The size of the majorant grid for a grid of so many voxels.
glm::ivec3 majorantCells(glm::dvec3 voxels);
/// Packs the cells and the majorants of a medium whose `density`, a grid of so many voxels, is already packed.
void packDensityCells(MediumTables&, medium& m, glm::dvec3 voxels);

/// Sets blackbody emission from the medium's packed `temperature`.
void packBlackbodyEmission(const MediumPacking&, const Medium&, medium& m);

}  // namespace eikonal
