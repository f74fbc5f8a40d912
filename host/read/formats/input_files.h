#pragma once
// The files that a scene is made of.

#include <string>
#include <vector>

namespace eikonal {

/// Readers call this for each file that they open. Thread-safe.
void noteInputFile(const std::string& path);
/// Forgets them: another scene is read.
void forgetInputFiles();
/// The files noted so far, each once, sorted.
std::vector<std::string> inputFiles();

/// A hash of a file's content, 16 hexadecimal digits; "none" if it cannot be read.
std::string contentHash(const std::string& path);

}  // namespace eikonal
