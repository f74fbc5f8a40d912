#include "render/device_team.h"

#include "device/context.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>

namespace eikonal {

/// Of several devices each takes so many batches of the size of its wave, or of the smallest wave.
constexpr unsigned batchesPerWave = 4;

unsigned DeviceTeam::mostPaths() const {
    unsigned fewest = ~0u;
    for (const RenderDevice& d : devices_) fewest = std::min(fewest, d.tracer->mostPaths());
    return size() == 1 ? fewest : std::max(fewest / batchesPerWave, 1u);
}

bool DeviceTeam::run(const std::function<bool()>& abandon, const std::function<void(const RenderDevice&)>& work) {
    return runOn(std::vector(devices_), abandon, work);
}

bool DeviceTeam::runFirst(const std::function<bool()>& abandon, const std::function<void(const RenderDevice&)>& work) {
    return runOn(std::vector{first()}, abandon, work);
}

bool DeviceTeam::runOn(std::span<const RenderDevice> devices, const std::function<bool()>& abandon,
                       const std::function<void(const RenderDevice&)>& work) {
    std::vector<const StopFlag*> flags;
    for (const RenderDevice& d : devices) flags.push_back(&d.tracer->stopFlag());
    const StopWatcher watcher(flags, abandon);
    std::mutex mutex;
    std::vector<const Tracer*> failed;
    std::exception_ptr error;   // that ends the work of all
    const auto fail = [&](const RenderDevice& device, const DeviceError& why) {
        const std::lock_guard lock(mutex);
        if (failed.size() + 1 == size()) { error = std::current_exception(); return; }
        failed.push_back(device.tracer);
        if (dropped_) dropped_(device, why);
    };
    /* Commands in flight may read and write host memory that goes with the error. If this fails as well, the first error says why */
    const auto drain = [](const RenderDevice& device) { clFinish(device.context->queue()); };
    const auto workOn = [&](const RenderDevice& device) {
        try {
            work(device);
            device.context->finish();
        } catch (const DeviceError& why) {
            drain(device);
            fail(device, why);
        } catch (...) {
            for (const StopFlag* flag : flags) flag->raise();
            drain(device);
            const std::lock_guard lock(mutex);
            error = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> others;
        for (const RenderDevice& device : devices.subspan(1)) others.emplace_back([&] { workOn(device); });
        workOn(devices.front());
    }
    if (error) std::rethrow_exception(error);
    const bool isInterrupted = std::ranges::any_of(flags, [](const StopFlag* flag) { return flag->isRaised(); });
    std::erase_if(devices_, [&](const RenderDevice& d) { return std::ranges::find(failed, d.tracer) != failed.end(); });
    return isInterrupted;
}

}  // namespace eikonal
