#include "read/formats/input_files.h"

#include "device/source.h"

#include <fmt/format.h>

#include <fstream>
#include <mutex>
#include <set>

namespace eikonal {
namespace {

struct Noted {
    std::mutex mutex;
    std::set<std::string> paths;
};
Noted& noted() {
    static Noted files;
    return files;
}

}  // namespace

void noteInputFile(const std::string& path) {
    const std::lock_guard lock(noted().mutex);
    noted().paths.insert(path);
}

void forgetInputFiles() {
    const std::lock_guard lock(noted().mutex);
    noted().paths.clear();
}

std::vector<std::string> inputFiles() {
    const std::lock_guard lock(noted().mutex);
    return {noted().paths.begin(), noted().paths.end()};
}

std::string contentHash(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return "none";
    std::string piece(1 << 20, 0);
    std::uint64_t hash = hashSeed;
    while (file) {
        file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
        hash = hashBytes(std::string_view(piece).substr(0, static_cast<std::size_t>(file.gcount())), hash);
    }
    return fmt::format("{:016x}", hash);
}

}  // namespace eikonal
