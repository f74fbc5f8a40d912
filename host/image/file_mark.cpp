#include "image/file_mark.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <filesystem>

namespace eikonal {

FileMark FileMark::of(const std::string& path) {
    struct stat found;
    if (stat(path.c_str(), &found) != 0) return {};
    return {found.st_dev, found.st_ino, found.st_mtim.tv_sec, found.st_mtim.tv_nsec};
}

std::string nameBeside(const std::string& path) {
    const std::filesystem::path place = path;
    for (int number = 2;; ++number) {
        std::filesystem::path name = place;
        name.replace_filename(fmt::format("{}-{}{}", place.stem().string(), number, place.extension().string()));
        std::error_code error;
        if (!std::filesystem::exists(name, error)) return name.string();
    }
}

}  // namespace eikonal
