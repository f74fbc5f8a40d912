#include "app/commands.h"
#include "render/session.h"
#include "app/statistics.h"

#include <fmt/format.h>

#include <cstdio>

namespace eikonal {

int listDevicesCommand(const Options& o) {
    prepareOpenCl(o.device);
    const std::vector<DeviceInfo> devices = listDevices();
    if (devices.empty()) throw DeviceError("no OpenCL device found. On Debian, `apt install pocl-opencl-icd` makes the CPU an OpenCL device.");
    for (size_t i = 0; i < devices.size(); ++i) {
        const DeviceInfo& d = devices[i];
        std::fputs(fmt::format("{}  {}\n   {}, {}, driver {}\n   {} compute units, {} of memory, {} in one buffer{}\n", i, d.name, d.platformName, d.version, d.driver, d.computeUnits,
                               readableBytes(static_cast<double>(d.memory)), readableBytes(static_cast<double>(d.largestBuffer)),
                               d.hasCompiler ? "" : "; it has no compiler and cannot render").c_str(), stdout);
    }
    return static_cast<int>(ExitCode::success);
}

}  // namespace eikonal
