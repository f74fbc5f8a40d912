#pragma once
// What kinds of media share when they are packed.

#include "kinds/medium_kind.h"
#include "pack/grids.h"
#include "pack/packer.h"

namespace eikonal {

/// A medium with the coefficients, emission and phase function of a description, the same everywhere.
medium newMedium(Packer&, const Medium&);

/// Heterogeneous media: lets it fill the box of corners p0 and p1 in its own space. Returns what takes the unit cube to that space.
glm::dmat4 packBox(const Packer&, const Medium&, glm::dvec3 p0, glm::dvec3 p1, medium& m);

/// Majorants on a grid of `cells`, where bound(low, high) is that of a part of the unit cube: no extinction in it is greater than this
/// times what multiplies the medium's majorants (bounded_x_medium).
template <class Bound> void packMajorants(SceneTables& tables, medium& m, glm::ivec3 cells, const Bound& bound) {
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
/// How many majorants a grid of so many voxels gets.
glm::ivec3 majorantCells(glm::dvec3 voxels);
/// Majorants of a medium whose `density`, a grid of so many voxels, is packed.
void packDensityMajorants(SceneTables&, medium& m, glm::dvec3 voxels);

/// Lets it emit what black bodies of its packed `temperature` do.
void packBlackbodyEmission(Packer&, const Medium&, medium& m);

}  // namespace eikonal
