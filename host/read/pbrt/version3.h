#pragma once
// Distinguishes pbrt-v3 from pbrt-v4. The languages look alike, but differ too much to read both.


#include <optional>
#include <string>

namespace eikonal::pbrt {

/// What pbrt-v4 has instead of a name that only pbrt-v3 knows, for a message. `noun` is "directive", "material", "shape", ... or
/// "parameter". Nothing if pbrt-v3 has no such name, or pbrt-v4 has it, too.
std::optional<std::string> successorOf(const std::string& noun, const std::string& name);

}  // namespace eikonal::pbrt
