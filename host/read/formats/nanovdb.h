#pragma once
// Sparse grids from NanoVDB files (Museth, "NanoVDB: A GPU-Friendly and Portable VDB Data Structure", 2021).

#include "read/formats/read_bytes.h"
#include "scene/scene.h"

#include <memory>
#include <string>
#include <vector>

namespace eikonal {

/// The names of all grids of a file. Throws ReadProblem.
std::vector<std::string> gridNames(const std::string& path);

/// The first grid of that name, values below 0 taken as 0; null if there is none. It must be of floats; ReadProblem is thrown if it is not,
/// if the file is damaged, or of a version that the library does not read.
std::shared_ptr<const SparseGrid> readNanoVdb(const std::string& path, const std::string& name);

}  // namespace eikonal
