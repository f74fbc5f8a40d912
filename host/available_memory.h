#pragma once
// The memory that the program may still take, and what it has taken.

#include <cstddef>
#include <string>

namespace eikonal {

/// Bytes that this process may still allocate: the least of what Linux estimates for the machine, swap included, and what each control
/// group around the process has left (a container's or a batch job's limit). The largest size_t if Linux tells neither. root: the folder
/// that holds proc and sys.
std::size_t availableMemory(const std::string& root = "/");

/// Bytes of memory that this process occupies, and the most that it has occupied so far; 0 if Linux does not tell. root: as above.
struct OccupiedMemory { std::size_t now = 0, most = 0; };
OccupiedMemory occupiedMemory(const std::string& root = "/");

}  // namespace eikonal
