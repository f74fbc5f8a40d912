#include "commands/clock.h"

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

namespace eikonal {

/// When the kernel started this process, in seconds since the machine did; see proc(5), field 22 of /proc/self/stat.
static double startedAt() {
    std::ifstream file("/proc/self/stat");
    std::string text;
    std::getline(file, text, '\0');
    /* The second field is the program's name in brackets, spaces and all; the third begins after it */
    std::istringstream fields(text.substr(std::min(text.rfind(')') + 1, text.size())));
    std::string field;
    constexpr int starttime = 22, firstLeft = 3;
    for (int i = firstLeft; i <= starttime; ++i) fields >> field;
    return std::strtod(field.c_str(), nullptr) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double secondsSinceStart() {
    timespec now{};
    clock_gettime(CLOCK_BOOTTIME, &now);
    return std::max(0.0, static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9 - startedAt());
}

}  // namespace eikonal
