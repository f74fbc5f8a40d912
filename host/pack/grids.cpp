#include "pack/grids.h"

#include "pack/space.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <stdexcept>

namespace eikonal {
namespace {

using Brick = std::array<float, BRICK_VALUES>;

size_t offsetIn(glm::ivec3 size, glm::ivec3 at) { return (static_cast<size_t>(at.z) * size.y + at.y) * size.x + at.x; }

/// The voxels from `first` on.
Brick brickOf(const Grid& grid, glm::ivec3 first) {
    Brick brick{};
    const glm::ivec3 size(grid.nx, grid.ny, grid.nz), low = glm::max(-first, glm::ivec3(0)),
                                                      high = glm::min(size - first, glm::ivec3(BRICK_SIDE));
    for (int z = low.z; z < high.z; ++z)
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x)
                brick[offsetIn(glm::ivec3(BRICK_SIDE), {x, y, z})] = grid.values[offsetIn(size, first + glm::ivec3(x, y, z))];
    return brick;
}

/// The same; `first` is a multiple of 8.
Brick brickOf(const SparseGrid& grid, glm::ivec3 first) {
    Brick brick{};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 part(corner & 1, (corner >> 1) & 1, corner >> 2), block = (first >> 3) - grid.firstBlock + part;
        if (glm::any(glm::lessThan(block, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(block, grid.blocks))) continue;
        const std::uint32_t stored = grid.blockOf[offsetIn(grid.blocks, block)];
        if (stored == SparseGrid::empty) continue;
        const glm::ivec3 end = glm::ivec3(8) - 7 * part;   // the whole block, or the layer of a following block that touches it
        for (int z = 0; z < end.z; ++z)
            for (int y = 0; y < end.y; ++y)
                for (int x = 0; x < end.x; ++x)
                    brick[offsetIn(glm::ivec3(BRICK_SIDE), 8 * part + glm::ivec3(x, y, z))] =
                        grid.values[512 * size_t(stored) + offsetIn(glm::ivec3(8), {x, y, z})];
    }
    return brick;
}

/// Bricks for the cells from voxel `first` to voxel `last`; values outside are 0.
template <class Voxels>
uint pack(MediumTables& tables, const Voxels& voxels, glm::ivec3 first, glm::ivec3 last, const glm::dmat4& voxelFromBox) {
    const glm::ivec3 bricks = (last - first) / BRICK_CELLS + 1;
    if (double(bricks.x) * bricks.y * bricks.z + static_cast<double>(tables.bricks.size()) > double(NONE))
        throw std::length_error("the grids have more bricks than 32 bits can count");
    grid packed{};
    packed.bricks_x = static_cast<uint>(bricks.x);
    packed.bricks_y = static_cast<uint>(bricks.y);
    packed.bricks_z = static_cast<uint>(bricks.z);
    packed.first_brick = static_cast<uint>(tables.bricks.size());
    glm::dmat4 cellFromVoxel(1);
    cellFromVoxel[3] = glm::dvec4(-glm::dvec3(first), 1);
    packed.cell_from_box = toAffine(cellFromVoxel * voxelFromBox);

    std::map<float, uint> constants;
    for (int z = 0; z < bricks.z; ++z)
        for (int y = 0; y < bricks.y; ++y)
            for (int x = 0; x < bricks.x; ++x) {
                const Brick brick = brickOf(voxels, first + BRICK_CELLS * glm::ivec3(x, y, z));
                const uint next = static_cast<uint>(tables.brick_values.size() / BRICK_VALUES);
                const bool isConstant = std::all_of(brick.begin(), brick.end(), [&](float value) { return value == brick[0]; });
                const uint which = isConstant ? constants.try_emplace(brick[0], next).first->second : next;
                if (which == next) tables.brick_values.insert(tables.brick_values.end(), brick.begin(), brick.end());
                tables.bricks.push_back(which);
            }
    tables.grids.push_back(packed);
    return static_cast<uint>(tables.grids.size() - 1);
}

}  // namespace

uint packGrid(MediumTables& tables, const Grid& grid, const glm::dmat4& voxelFromBox) {
    return pack(tables, grid, glm::ivec3(-1), glm::ivec3(grid.nx, grid.ny, grid.nz) - 1, voxelFromBox);
}
uint packGrid(MediumTables& tables, const SparseGrid& grid, const glm::dmat4& voxelFromBox) {
    return pack(tables, grid, (grid.low - 1) >> 3 << 3, grid.high, voxelFromBox);
}

glm::dmat4 voxelFromBox(int nx, int ny, int nz) {
    glm::dmat4 m(1);
    const glm::dvec3 size(nx, ny, nz);
    for (int axis = 0; axis < 3; ++axis) {
        m[axis][axis] = size[axis];
        m[3][axis] = -0.5;
    }
    return m;
}

float boundOn(const MediumTables& tables, uint index, glm::dvec3 low, glm::dvec3 high) {
    /* The cells that overlap the part (if rotated, its bounding box), enlarged for rounding in single precision */
    const grid& g = tables.grids[index];
    Box cells;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 p(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z, 1);
        const affine& m = g.cell_from_box;
        cells.grow({m.xx * p.x + m.xy * p.y + m.xz * p.z + m.xw, m.yx * p.x + m.yy * p.y + m.yz * p.z + m.yw,
                    m.zx * p.x + m.zy * p.y + m.zz * p.z + m.zw});
    }
    const glm::ivec3 bricks(g.bricks_x, g.bricks_y, g.bricks_z);
    const glm::dvec3 size = double(BRICK_CELLS) * glm::dvec3(bricks);
    const glm::ivec3 first(glm::clamp(glm::floor(cells.low - 1e-4 * glm::dvec3(1)), glm::dvec3(0), size));
    const glm::ivec3 last(glm::clamp(glm::floor(cells.high + 1e-4 * glm::dvec3(1)), glm::dvec3(-1), size - 1.));   // of cells, inclusive

    float most = 0;
    for (int bz = first.z / BRICK_CELLS; bz * BRICK_CELLS <= last.z; ++bz)
        for (int by = first.y / BRICK_CELLS; by * BRICK_CELLS <= last.y; ++by)
            for (int bx = first.x / BRICK_CELLS; bx * BRICK_CELLS <= last.x; ++bx) {
                const glm::ivec3 brick(bx, by, bz), from = glm::max(first - BRICK_CELLS * brick, glm::ivec3(0));
                const glm::ivec3 to = glm::min(last + 1 - BRICK_CELLS * brick, glm::ivec3(BRICK_CELLS));   // corners of cells, inclusive
                const float* values = &tables.brick_values[size_t(BRICK_VALUES) * tables.bricks[g.first_brick + offsetIn(bricks, brick)]];
                for (int z = from.z; z <= to.z; ++z)
                    for (int y = from.y; y <= to.y; ++y) {
                        const float* row = values + offsetIn(glm::ivec3(BRICK_SIDE), {0, y, z});
                        for (int x = from.x; x <= to.x; ++x) most = std::max(most, row[x]);
                    }
            }
    return most;
}

}  // namespace eikonal
