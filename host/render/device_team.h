#pragma once
// The devices that render an image together.

#include "error.h"
#include "render/profile.h"
#include "render/tracer.h"

#include <functional>
#include <span>
#include <vector>

namespace eikonal {

/// A device that renders. All must outlive the render.
struct RenderDevice {
    const Context* context;
    Tracer* tracer;
    Profile* profile;   ///< counts the paths that it has traced
};

/// Devices work at the same time, each on a thread of its own. One that fails is dropped: the others do its work.
class DeviceTeam {
public:
    /// dropped: told at once of each that fails while others are left, by the thread of that device. May be empty.
    DeviceTeam(std::span<const RenderDevice> devices, std::function<void(const RenderDevice&, const DeviceError&)> dropped)
        : devices_(devices.begin(), devices.end()), dropped_(std::move(dropped)) {}

    size_t size() const { return devices_.size(); }
    const RenderDevice& first() const { return devices_.front(); }
    const std::vector<RenderDevice>& devices() const { return devices_; }
    /// The most paths of a batch: so few, if there are several devices, that fast ones get more of them than slow ones.
    unsigned mostPaths() const;
    /// Calls work(device) for each, at the same time, and waits until all have returned and their devices are idle. Those whose work throws
    /// a DeviceError are dropped; the last one's error, and every other exception, ends the work of all and is thrown.
    /// abandon: asked every few milliseconds; true: all devices are interrupted. May be empty.
    /// Returns whether they were.
    bool run(const std::function<bool()>& abandon, const std::function<void(const RenderDevice&)>& work);
    /// The same for the first device alone.
    bool runFirst(const std::function<bool()>& abandon, const std::function<void(const RenderDevice&)>& work);

private:
    bool runOn(std::span<const RenderDevice> devices, const std::function<bool()>& abandon,
               const std::function<void(const RenderDevice&)>& work);

    std::vector<RenderDevice> devices_;
    std::function<void(const RenderDevice&, const DeviceError&)> dropped_;
};

}  // namespace eikonal
