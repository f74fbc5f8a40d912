#pragma once
// A word to the user while something takes longer than expected.

#include "app/clock.h"

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace eikonal {

/// While it lives: after half a second, says on standard error what is being waited for; on a terminal also for how long so far,
/// and wipes that away in the end.
class WaitNotice {
public:
    WaitNotice(std::string what, bool silent);
    ~WaitNotice();

private:
    void watch();
    std::string what_;
    Stopwatch time_;
    bool over_ = false;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::thread watcher_;
};

}  // namespace eikonal
