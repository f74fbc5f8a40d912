#pragma once
// A device that is open, with the compiler that keeps what it has built for it.

#include "device/context.h"
#include "device/program.h"
#include "render/options.h"
#include "render/stages.h"

namespace eikonal {

/// Sessions that follow one another may share it: opening a device reads a whole compiler from disk, and kernels are loaded once.
struct OpenDevice {
    /// Throws a DeviceError if there is no such device, a UsageError if it cannot have the shape that is asked for. profiling: kernels are
    /// timed.
    OpenDevice(const DeviceOptions& options, bool profiling);

    Context context;
    Compiler compiler;
    StageShape shape;
};

/// Where compiled kernels are kept; empty: nowhere.
std::string cacheFolderFor(const DeviceOptions& options);
StageShape shapeFor(const DeviceInfo& device, const DeviceOptions& options);
BuildSettings buildSettingsFor(const DeviceOptions& options);

}  // namespace eikonal
