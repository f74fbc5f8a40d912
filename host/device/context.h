#pragma once
// Platforms and devices, and the context of the device that renders.

#include "device/check.h"

#include <string>
#include <vector>

namespace eikonal {

/// Properties of a device.
struct DeviceInfo {
    cl_platform_id platform = nullptr;
    cl_device_id id = nullptr;
    std::string name, vendor, version, driver, platformName;
    bool isCpu = false;
    unsigned computeUnits = 1;
    size_t memory = 0;          ///< bytes; on a CPU, what PoCL reports, which is not a limit
    size_t largestBuffer = 0;   ///< bytes in one allocation
    size_t largestGroup = 1;    ///< work-items per work-group
    bool hasCompiler = true;
    bool widensGroups = false;  ///< the compiler vectorises over work-items, so kernels should not loop over slots
};

/// All devices of all platforms, in the order of --device indices. Platforms without devices are skipped. A device that cannot be queried
/// is listed without a compiler; its name contains the reason.
std::vector<DeviceInfo> listDevices();

/// The device that `wanted` selects: empty for the best device with a compiler (GPUs before CPUs), an index into the list, or part of a
/// name, case-insensitive. Throws a DeviceError that lists the devices.
DeviceInfo chooseDevice(const std::string& wanted);
DeviceInfo chooseDevice(const std::vector<DeviceInfo>& list, const std::string& wanted);
/// Of several devices, that render together: what selects each (chooseDevice), in their order. `wanted` is "all", for all that have a
/// compiler, or a list of such selections with commas, or one of them. Throws a DeviceError if one is there twice, or not at all.
std::vector<std::string> chooseDevices(const std::vector<DeviceInfo>& list, const std::string& wanted);

using ContextHandle = Owned<cl_context, clReleaseContext>;
using QueueHandle = Owned<cl_command_queue, clReleaseCommandQueue>;

/// A device, its context, and one in-order queue of commands.
class Context {
public:
    /// profiling: record start and end times of commands.
    explicit Context(const DeviceInfo& device, bool profiling = false);

    const DeviceInfo& device() const { return device_; }
    cl_context handle() const { return context_; }
    cl_command_queue queue() const { return queue_; }
    bool profiling() const { return profiling_; }
    /// Waits for all enqueued commands.
    void finish() const;
    /// Submits all enqueued commands to the device without waiting.
    void flush() const;

private:
    DeviceInfo device_;
    ContextHandle context_;
    QueueHandle queue_;
    bool profiling_;
};

}  // namespace eikonal
