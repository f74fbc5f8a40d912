#pragma once
// Whole files in memory.

#include <stdexcept>
#include <string>
#include <vector>

namespace eikonal {

/// Why a file could not be read, as the end of a sentence that began with its name: "cannot be opened: No such file or directory".
struct ReadProblem : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The bytes of a file; of a gzip-compressed one (whatever it is called), what was compressed. Throws ReadProblem.
std::vector<char> readBytes(const std::string& path);

}  // namespace eikonal
