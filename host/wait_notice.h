#pragma once
// Tells the user when something takes longer than expected.

#include "clock.h"

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace eikonal {

/// If this object lives longer than half a second, it prints what the program is waiting for on standard error; on a terminal it also shows
/// the seconds so far, and clears the line at the end.
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
