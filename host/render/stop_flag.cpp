#include "render/stop_flag.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace eikonal {

/// How often a StopWatcher asks.
constexpr std::chrono::milliseconds watchInterval(20);

/// A page, since OpenCL implementations ask for alignment.
struct alignas(4096) StopFlag::Word {
    std::atomic<cl_uint> value = 0;
    char rest[4096 - sizeof(cl_uint)] = {};
};

StopFlag::StopFlag(const Context& context)
    : word_(std::make_shared<Word>()), buffer_(Buffer::over(context, word_.get(), sizeof(Word), "table stop")) {
    /* Oclgrind does not count memory of the host as initialised */
    const cl_uint zero = 0;
    buffer_.write(context, &zero, sizeof zero);
}

void StopFlag::raise() const { word_->value = 1; }
void StopFlag::lower() const { word_->value = 0; }
bool StopFlag::isRaised() const { return word_->value != 0; }

StopWatcher::StopWatcher(std::vector<const StopFlag*> flags, std::function<bool()> isDue) : flags_(std::move(flags)) {
    if (!isDue) return;
    thread_ = std::jthread([this, isDue = std::move(isDue)](const std::stop_token& ended) {
        std::mutex mutex;
        std::condition_variable_any end;
        std::unique_lock lock(mutex);
        while (!isDue())
            if (end.wait_for(lock, ended, watchInterval, [&] { return ended.stop_requested(); })) return;
        for (const StopFlag* flag : flags_) flag->raise();
    });
}

StopWatcher::~StopWatcher() {
    if (thread_.joinable()) {
        thread_.request_stop();
        thread_.join();
    }
    for (const StopFlag* flag : flags_) flag->lower();
}

}  // namespace eikonal
