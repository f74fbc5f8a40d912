#pragma once
// Text files, compressed or not.

#include "error.h"

#include <string>

namespace eikonal::pbrt {

/// The whole text of a file, inflated if it is gzip; a UTF-8 byte order mark is dropped.
/// Throws SceneError: it cannot be read, its gzip data is damaged, or it is UTF-16.
std::string readTextFile(const std::string& path);

}  // namespace eikonal::pbrt
