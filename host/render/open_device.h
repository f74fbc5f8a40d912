#pragma once
// A device that is open, with the compiler that keeps what it has built for it.

#include "device/context.h"
#include "device/program.h"
#include "render/options.h"
#include "render/stages.h"

#include <memory>
#include <vector>

namespace eikonal {

/// Sessions that follow one another may share it: opening a device reads a whole compiler from disk, and kernels are loaded once.
struct OpenDevice {
    /// options: of this device alone. Throws a DeviceError if there is no such device, a UsageError if it cannot have the shape that is
    /// asked for. profiling: kernels are timed.
    OpenDevice(const DeviceOptions& options, bool profiling);

    DeviceOptions options;
    Context context;
    Compiler compiler;
    StageShape shape;
};

/// The devices that render together, the first of which does what is done once; empty: none is open yet.
using OpenDevices = std::vector<std::shared_ptr<OpenDevice>>;
/// Opens all devices that the options name.
OpenDevices openDevices(const DeviceOptions& options, bool profiling);

/// Where compiled kernels are kept; empty: nowhere.
std::string cacheFolderFor(const DeviceOptions& options);
StageShape shapeFor(const DeviceInfo& device, const DeviceOptions& options);
BuildSettings buildSettingsFor(const DeviceOptions& options);

}  // namespace eikonal
