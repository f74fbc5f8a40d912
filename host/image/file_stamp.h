#pragma once
// Tells whether a file is still the one that was there before.

#include <array>
#include <cstdint>
#include <string>

namespace eikonal {

/// What changes with a file: its size, time and place on the disk. Zeros: there is no such file.
using FileStamp = std::array<std::int64_t, 5>;
FileStamp stampOf(const std::string& path);

}  // namespace eikonal
