#pragma once
// Sparse grids from NanoVDB files (Museth, "NanoVDB: A GPU-Friendly and Portable VDB Data Structure", 2021).

#include "read/formats/read_bytes.h"
#include "scene/media.h"

#include <memory>
#include <string>
#include <vector>

namespace eikonal {

/// The names of all grids in a file. Throws ReadProblem.
std::vector<std::string> gridNames(const std::string& path);

/// The first grid called `name`, with negative values clamped to 0; null if there is none. Throws ReadProblem if it is not a grid of
/// floats, if the file is damaged, or if the library does not read its version.
std::shared_ptr<const SparseGrid> readNanoVdb(const std::string& path, const std::string& name);

}  // namespace eikonal
