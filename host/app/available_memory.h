#pragma once
// The memory that the machine has available.

#include <cstddef>

namespace eikonal {

/// Bytes that programs may still allocate, swap included, as Linux estimates it; the largest size_t if Linux gives no estimate.
std::size_t availableMemory();

}  // namespace eikonal
