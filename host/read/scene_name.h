#pragma once
// What a scene is called.

#include <string>

namespace eikonal {

/// The name of a scene's file without folder, .gz and extension; "stdin" for standard input ("-"). Its image is called like it.
std::string sceneName(const std::string& path);

}  // namespace eikonal
