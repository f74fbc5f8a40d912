#pragma once
// Reads text files, compressed or not.


#include <string>

namespace eikonal::pbrt {

/// The text of a file, decompressed if it is gzip; without a UTF-8 byte order mark. Throws SceneError if the file cannot be read, is
/// damaged, or is UTF-16.
std::string readTextFile(const std::string& path);

/// The same for standard input.
std::string readStandardInput(const std::string& nameForMessages);

}  // namespace eikonal::pbrt
