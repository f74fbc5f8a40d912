#pragma once
// Work beside the calling thread.

#include <future>
#include <system_error>
#include <utility>

namespace eikonal {

/// Starts f() on a thread of its own. Where the system has no thread left, f() runs when its result is asked for.
template <class F> auto inBackground(F f) -> std::future<decltype(f())> {
    try {
        return std::async(std::launch::async, f);
    } catch (const std::system_error&) {
        return std::async(std::launch::deferred, std::move(f));
    }
}

}  // namespace eikonal
