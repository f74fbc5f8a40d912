#include "view/http/limited_stream.h"

#include <algorithm>
#include <cstring>

#include <poll.h>

namespace eikonal {

using Clock = std::chrono::steady_clock;

/// How long a browser may take nothing of an answer.
constexpr std::chrono::seconds writePatience(5);

bool LimitedStream::waitFor(short events, Clock::time_point end) const {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    struct pollfd state {
        socket_, events, 0
    };
    return left > 0 && ::poll(&state, 1, static_cast<int>(left)) == 1;
}

bool LimitedStream::is_readable() const { return at_ < end_ || waitFor(POLLIN, readEnd_); }
bool LimitedStream::is_writable() const { return waitFor(POLLOUT, Clock::now() + writePatience); }

ssize_t LimitedStream::read(char* to, std::size_t size) {
    if (at_ == end_) {
        if (left_ == 0 || !waitFor(POLLIN, readEnd_)) return -1;
        const ssize_t got = ::recv(socket_, buffer_, std::min(sizeof buffer_, left_), 0);
        if (got <= 0) return got;
        at_ = 0;
        end_ = static_cast<std::size_t>(got);
        left_ -= end_;
    }
    const std::size_t count = std::min(size, end_ - at_);
    std::memcpy(to, buffer_ + at_, count);
    at_ += count;
    return static_cast<ssize_t>(count);
}

ssize_t LimitedStream::write(const char* from, std::size_t size) {
    return is_writable() ? ::send(socket_, from, size, MSG_NOSIGNAL | MSG_DONTWAIT) : -1;
}

}  // namespace eikonal
