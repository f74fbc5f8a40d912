#pragma once
// How to tell pbrt-v3's language from pbrt-v4's: they are alike enough to mix up, and too different to read both.

#include "read/pbrt/problems.h"

#include <string>

namespace eikonal::pbrt {

/// What pbrt-v4 has in place of something that only pbrt-v3 knows: `noun` is "directive", "material", "shape", ... or
/// "parameter"; the answer is meant for a message. Null if pbrt-v3 has nothing of that name, or pbrt-v4 has it as well.
const char* successorOf(const std::string& noun, const std::string& name);

}  // namespace eikonal::pbrt
