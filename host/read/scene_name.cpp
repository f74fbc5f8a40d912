#include "read/scene_name.h"

#include "standard_stream.h"

#include <filesystem>

namespace eikonal {

std::string sceneName(const std::string& path) {
    if (isStandardStream(path)) return "stdin";
    std::filesystem::path name = std::filesystem::path(path).filename();
    if (name.extension() == ".gz") name = name.stem();
    return name.stem().string();
}

}  // namespace eikonal
