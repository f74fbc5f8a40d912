#include "app/available_memory.h"

#include <fstream>
#include <limits>
#include <string>

namespace eikonal {

std::size_t availableMemory() {
    std::ifstream file("/proc/meminfo");
    std::size_t kibibytes = 0, bytes = 0;
    bool isKnown = false;
    for (std::string name, unit; file >> name >> kibibytes; std::getline(file, unit))
        if (name == "MemAvailable:" || name == "SwapFree:") {
            bytes += kibibytes * 1024;
            isKnown |= name == "MemAvailable:";
        }
    return isKnown ? bytes : std::numeric_limits<std::size_t>::max();
}

}  // namespace eikonal
