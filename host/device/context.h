#pragma once
// Platforms, devices, and the one device that renders.

#include "device/check.h"

#include <string>
#include <vector>

namespace eikonal {

/// What is worth knowing of a device.
struct DeviceInfo {
    cl_platform_id platform = nullptr;
    cl_device_id id = nullptr;
    std::string name, vendor, version, driver, platformName;
    bool isCpu = false;
    unsigned computeUnits = 1;
    size_t memory = 0;          ///< bytes; on a CPU PoCL's idea, not a limit
    size_t largestBuffer = 0;   ///< bytes in one allocation
    size_t largestGroup = 1;    ///< work-items in a work-group
    bool hasCompiler = true;
    bool widensGroups = false;  ///< it makes SIMD lanes of work-items, so these had better not loop over slots themselves
};

/// Every device of every platform, in the order in which --device counts them. Platforms without devices are passed over;
/// a device that does not answer is there without a compiler, its name saying why.
std::vector<DeviceInfo> listDevices();

/// The device that `wanted` means: empty for the best of those with a compiler (a GPU before a CPU), a number in that list, or a part of a
/// name, upper or lower case. Throws a DeviceError that lists what there is.
DeviceInfo chooseDevice(const std::string& wanted);
DeviceInfo chooseDevice(const std::vector<DeviceInfo>& list, const std::string& wanted);

using ContextHandle = Owned<cl_context, clReleaseContext>;
using QueueHandle = Owned<cl_command_queue, clReleaseCommandQueue>;

/// A device, its context, and one in-order queue of commands.
class Context {
public:
    /// profiling: commands remember when they started and ended.
    explicit Context(const DeviceInfo& device, bool profiling = false);

    const DeviceInfo& device() const { return device_; }
    cl_context handle() const { return context_; }
    cl_command_queue queue() const { return queue_; }
    bool profiling() const { return profiling_; }
    /// Waits for all that was enqueued.
    void finish() const;
    /// Hands what was enqueued to the device without waiting.
    void flush() const;

private:
    DeviceInfo device_;
    ContextHandle context_;
    QueueHandle queue_;
    bool profiling_;
};

}  // namespace eikonal
