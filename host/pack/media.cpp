// Participating media: coefficients per unit of scene space, and bounds on the density of grids.

#include "pack/packer.h"

#include <cmath>

namespace eikonal {

/// The largest density that interpolation can give anywhere in each cell of a MAJORANT_CELLS^3 grid.
static void packMajorants(std::vector<float>& majorants, const Grid& grid) {
    const auto range = [](int cell, int n) {
        /* Samples that touch the cell: values lie at (i + 1/2) / n and are interpolated linearly */
        const double low = static_cast<double>(cell) / MAJORANT_CELLS * n - 0.5, high = static_cast<double>(cell + 1) / MAJORANT_CELLS * n - 0.5;
        return std::pair(std::clamp(static_cast<int>(std::floor(low)), 0, n - 1), std::clamp(static_cast<int>(std::floor(high)) + 1, 0, n - 1));
    };
    for (int z = 0; z < MAJORANT_CELLS; ++z)
        for (int y = 0; y < MAJORANT_CELLS; ++y)
            for (int x = 0; x < MAJORANT_CELLS; ++x) {
                const auto [x0, x1] = range(x, grid.nx);
                const auto [y0, y1] = range(y, grid.ny);
                const auto [z0, z1] = range(z, grid.nz);
                float most = 0;
                for (int k = z0; k <= z1; ++k)
                    for (int j = y0; j <= y1; ++j)
                        for (int i = x0; i <= x1; ++i) most = std::max(most, grid.values[(static_cast<size_t>(k) * grid.ny + j) * grid.nx + i]);
                majorants.push_back(most);
            }
}

static uint packGrid(std::vector<float>& table, const Grid& grid) {
    const uint first = static_cast<uint>(table.size());
    table.insert(table.end(), grid.values.begin(), grid.values.end());
    return first;
}

static medium packMedium(Packer& packer, const Medium& description) {
    SceneTables& tables = packer.packed.tables;
    medium m{};
    m.kind = description.kind == MediumKind::homogeneous ? kind_homogeneous_medium : kind_uniformgrid_medium;
    m.sigma_a = packCoefficient(packer, description.sigmaA, 1 / packer.space.scale);
    m.sigma_s = packCoefficient(packer, description.sigmaS, 1 / packer.space.scale);
    m.Le = packEmission(packer, description.Le);
    m.g = static_cast<float>(std::clamp(description.g, -0.99, 0.99));
    m.first_density = m.first_Le = m.first_majorant = NONE;
    if (description.kind == MediumKind::homogeneous) return m;

    const Grid& grid = description.density;
    m.nx = static_cast<uint>(grid.nx);
    m.ny = static_cast<uint>(grid.ny);
    m.nz = static_cast<uint>(grid.nz);
    m.first_density = packGrid(tables.densities, grid);
    if (!description.LeScale.values.empty()) m.first_Le = packGrid(tables.densities, description.LeScale);
    m.first_majorant = static_cast<uint>(tables.majorants.size());
    packMajorants(tables.majorants, grid);
    glm::dmat4 gridFromMedium(1);
    const glm::dvec3 extent = description.p1 - description.p0;
    for (int axis = 0; axis < 3; ++axis) {
        gridFromMedium[axis][axis] = 1 / extent[axis];
        gridFromMedium[3][axis] = -description.p0[axis] / extent[axis];
    }
    m.grid_from_scene = toAffine(gridFromMedium * glm::inverse(description.worldFromMedium) * packer.space.worldFromScene());
    return m;
}

void packMedia(Packer& packer) {
    if (!packer.hasMedia) return;
    for (const Medium& description : packer.scene.media) {
        packer.packed.require(description.kind == MediumKind::homogeneous ? Feature::MEDIUM_HOMOGENEOUS : Feature::MEDIUM_UNIFORMGRID,
                              description.where.toString() + ": medium \"" + description.name + "\"");
        packer.packed.require(Feature::MEDIA, description.where.toString() + ": medium \"" + description.name + "\"");
        packer.packed.tables.media.push_back(packMedium(packer, description));
    }
}

}  // namespace eikonal
