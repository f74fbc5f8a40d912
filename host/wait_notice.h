#pragma once
// Tells the user when something takes longer than expected.

#include "clock.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace eikonal {

/// If this object lives longer than half a second, it tells what the program is waiting for, in the form of progress that is asked for
/// (messages.h). A terminal also shows the seconds so far.
class WaitNotice {
public:
    WaitNotice(std::string what, bool silent);

    /// Parts that are done so far, of `all`.
    struct Parts { const std::atomic<int>* done; int all; };
    /// Also tells how many parts are done. brief: names them on a terminal, such as "compiling kernels".
    WaitNotice(std::string what, std::string brief, Parts parts, bool silent);
    ~WaitNotice();
    WaitNotice(const WaitNotice&) = delete;
    WaitNotice& operator=(const WaitNotice&) = delete;

private:
    void watch();
    void show(bool isFirst);
    std::string what_, brief_;
    Parts parts_{nullptr, 0};
    Stopwatch time_;
    double shownAt_ = 0;
    int shownDone_ = 0;
    bool over_ = false;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::thread watcher_;
};

}  // namespace eikonal
