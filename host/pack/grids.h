#pragma once
// Grids as bricks (include/eikonal/medium.h), and bounds of their interpolated values.

#include "pack/tables.h"
#include "scene/media.h"

#include <glm/glm.hpp>

namespace eikonal {

/// Appends a grid to the tables, as bricks; returns its index in `grids`. Equal constant bricks are stored once.
/// voxelFromBox maps the medium's unit cube to voxel space, where voxel (i, j, k) has its value at the point (i, j, k); the value outside
/// is 0. Throws std::length_error for more bricks than 32 bits can count.
uint packGrid(MediumTables& tables, const Grid& grid, const glm::dmat4& voxelFromBox);
uint packGrid(MediumTables& tables, const SparseGrid& grid, const glm::dmat4& voxelFromBox);

/// voxelFromBox of a regular grid with values at the centres of its cells, which fill the unit cube.
glm::dmat4 voxelFromBox(int nx, int ny, int nz);

/// A tight upper bound of a packed grid's interpolated values in a part of the unit cube.
float boundOn(const MediumTables& tables, uint grid, glm::dvec3 low, glm::dvec3 high);

}  // namespace eikonal
