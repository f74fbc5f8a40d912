#pragma once
// Reads whole files into memory.

#include <stdexcept>
#include <string>
#include <vector>

namespace eikonal {

/// The reason why a file could not be read, phrased to follow the file's name: "cannot be opened: No such file or directory".
struct ReadProblem : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The bytes of a file, decompressed if it is gzip (whatever its name). Throws ReadProblem.
std::vector<char> readBytes(const std::string& path);
/// The same for standard input.
std::vector<char> readInputBytes();

}  // namespace eikonal
