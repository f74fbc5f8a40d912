#include "available_memory.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

namespace eikonal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

/// What the whole machine has left, swap included.
std::size_t leftInMachine(const fs::path& proc) {
    std::ifstream file(proc / "meminfo");
    std::size_t kibibytes = 0, bytes = 0;
    bool isKnown = false;
    for (std::string name, unit; file >> name >> kibibytes; std::getline(file, unit))
        if (name == "MemAvailable:" || name == "SwapFree:") {
            bytes += kibibytes * 1024;
            isKnown |= name == "MemAvailable:";
        }
    return isKnown ? bytes : unlimited;
}

/// The number in a file; nothing if there is none, as in "max".
std::optional<std::size_t> numberIn(const fs::path& path) {
    std::ifstream file(path);
    std::size_t number = 0;
    return file >> number ? std::optional(number) : std::nullopt;
}

/// The value of a row "name value ..." of a file, 0 without one.
std::size_t rowOf(const fs::path& path, const std::string& wanted) {
    std::ifstream file(path);
    std::size_t value = 0;
    for (std::string name, rest; file >> name; std::getline(file, rest))
        if (name == wanted && file >> value) return value;
    return 0;
}

/// What the groups from `path` up to `root` let their processes still take. Files that the kernel keeps in memory are given up when needed.
std::size_t leftInGroups(const fs::path& root, fs::path path, const char* limitFile, const char* usageFile, const char* filePages) {
    std::size_t left = unlimited;
    for (;; path = path.parent_path()) {
        const fs::path folder = root / path.relative_path();
        const auto limit = numberIn(folder / limitFile), usage = numberIn(folder / usageFile);
        if (limit && usage) {
            const std::size_t taken = *usage - std::min(*usage, rowOf(folder / "memory.stat", filePages));
            left = std::min(left, *limit - std::min(*limit, taken));
        }
        if (path == path.parent_path()) return left;
    }
}

/// What the control groups of this process have left (cgroups(7), versions 1 and 2).
std::size_t leftInGroups(const fs::path& proc, const fs::path& groups) {
    std::ifstream file(proc / "self/cgroup");
    std::size_t left = unlimited;
    for (std::string line; std::getline(file, line);) {  // number:controllers:path
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == line.npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1), path = line.substr(second + 1);
        if (controllers.empty())
            left = std::min(left, leftInGroups(groups, path, "memory.max", "memory.current", "inactive_file"));
        else if (("," + controllers + ",").find(",memory,") != std::string::npos)
            left = std::min(left, leftInGroups(groups / "memory", path, "memory.limit_in_bytes", "memory.usage_in_bytes",
                                               "total_inactive_file"));
    }
    return left;
}

}  // namespace

std::size_t availableMemory(const std::string& root) {
    const fs::path proc = fs::path(root) / "proc";
    return std::min(leftInMachine(proc), leftInGroups(proc, fs::path(root) / "sys/fs/cgroup"));
}

OccupiedMemory occupiedMemory(const std::string& root) {
    const fs::path status = fs::path(root) / "proc/self/status";
    return {1024 * rowOf(status, "VmRSS:"), 1024 * rowOf(status, "VmHWM:")};
}

}  // namespace eikonal
