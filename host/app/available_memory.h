#pragma once
// How much memory the machine has left.

#include <cstddef>

namespace eikonal {

/// Bytes that programs may still take, swap included, as Linux estimates it; the largest number if it does not say.
std::size_t availableMemory();

}  // namespace eikonal
