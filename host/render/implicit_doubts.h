#pragma once
// What single precision could not decide at implicit surfaces while rendering.

#include "eikonal/shape.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace eikonal {

/// A count for each enum implicit_doubt, of all paths: those of surveys and from lights are among them.
using ImplicitDoubts = std::array<uint, implicit_doubt_count>;

/// One sentence for each kind of doubt that may show in an image of that many camera paths.
std::vector<std::string> describe(const ImplicitDoubts& counts, uint64_t paths);

}  // namespace eikonal
