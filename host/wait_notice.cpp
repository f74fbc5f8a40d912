#include "wait_notice.h"

#include <fmt/format.h>

#include <unistd.h>

#include <cstdio>

namespace eikonal {

WaitNotice::WaitNotice(std::string what, bool silent) : what_(std::move(what)) {
    if (!silent) watcher_ = std::thread([this] { watch(); });
}

WaitNotice::~WaitNotice() {
    {
        std::lock_guard lock(mutex_);
        over_ = true;
    }
    wake_.notify_all();
    if (watcher_.joinable()) watcher_.join();
}

void WaitNotice::watch() {
    using namespace std::chrono_literals;
    std::unique_lock lock(mutex_);
    const auto isOver = [this] { return over_; };
    if (wake_.wait_for(lock, 500ms, isOver)) return;
    if (!isatty(STDERR_FILENO)) {
        std::fputs((what_ + "\n").c_str(), stderr);
        return;
    }
    do {
        std::fputs(fmt::format("\r{}: {:.0f} s\x1b[K", what_, time_.seconds()).c_str(), stderr);
        std::fflush(stderr);
    } while (!wake_.wait_for(lock, 250ms, isOver));
    std::fputs("\r\x1b[K", stderr);
}

}  // namespace eikonal
