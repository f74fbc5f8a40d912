#pragma once
// How a render is interrupted: a word that kernels read while they run, and the thread that sets it.

#include "device/buffer.h"

#include <functional>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace eikonal {

/// The table "stop" of kernels (include/eikonal/scene.h). Once it is raised, tracing stages end their rays at once, so what they have added
/// to paths in flight is void. A CPU sees it while a kernel runs; other devices may see it only in later launches.
class StopFlag {
public:
    explicit StopFlag(const Context& context);
    void raise() const;
    void lower() const;
    /// While it is false, nothing that the device has finished was cut short.
    bool isRaised() const;
    const Buffer& buffer() const { return buffer_; }

private:
    struct Word;
    std::shared_ptr<Word> word_;   ///< must outlive the buffer
    Buffer buffer_;
};

/// While it lives, a thread asks `isDue` every few milliseconds and raises the flags once it answers true; in the end they are lowered.
/// `isDue` may be empty.
class StopWatcher {
public:
    StopWatcher(std::vector<const StopFlag*> flags, std::function<bool()> isDue);
    StopWatcher(const StopFlag& flag, std::function<bool()> isDue) : StopWatcher(std::vector{&flag}, std::move(isDue)) {}
    ~StopWatcher();
    StopWatcher(const StopWatcher&) = delete;
    StopWatcher& operator=(const StopWatcher&) = delete;

private:
    std::vector<const StopFlag*> flags_;
    std::jthread thread_;
};

}  // namespace eikonal
