#pragma once
// Grids of numbers as the device reads them: bricks (include/eikonal/medium.h), and bounds on what interpolation gives.

#include "pack/space.h"
#include "pack/tables.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

namespace eikonal {

/// Appends a grid to the tables, as bricks; returns its index in `grids`. Bricks that are the same number everywhere are stored once.
/// voxelFromBox takes the medium's unit cube to where voxel (i, j, k) has its value at the point (i, j, k); outside of the voxels
/// there is 0. Throws std::length_error for more bricks than can be counted.
uint packGrid(MediumTables& tables, const Grid& grid, const glm::dmat4& voxelFromBox);
uint packGrid(MediumTables& tables, const SparseGrid& grid, const glm::dmat4& voxelFromBox);

/// voxelFromBox of a regular grid: values lie in the middle of its cells, which fill the unit cube.
glm::dmat4 voxelFromBox(int nx, int ny, int nz);

/// The least that bounds what interpolation gives of a packed grid in a part of the unit cube.
float boundOn(const MediumTables& tables, uint grid, glm::dvec3 low, glm::dvec3 high);

}  // namespace eikonal
