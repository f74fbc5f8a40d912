#include "render/thread_limit.h"

#include "error.h"

#include <fmt/format.h>

#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace eikonal {

/// Threads beside those of TBB and the device: the scene's, one that watches for stops, one that tells what takes long, and one to spare.
constexpr int otherThreads = 4;

/// How many of `wanted` threads can be there at once.
static int startableThreads(int wanted) {
    std::mutex mutex;
    std::condition_variable end;
    bool isOver = false;
    std::vector<std::thread> threads;
    try {
        while (static_cast<int>(threads.size()) < wanted)
            threads.emplace_back([&] {
                std::unique_lock lock(mutex);
                end.wait(lock, [&] { return isOver; });
            });
    } catch (const std::system_error&) {
        /* That is the limit */
    }
    {
        const std::lock_guard lock(mutex);
        isOver = true;
    }
    end.notify_all();
    for (std::thread& thread : threads) thread.join();
    return static_cast<int>(threads.size());
}

int affordableThreads(int wanted) {
    const int startable = startableThreads(2 * wanted + otherThreads), threads = (startable - otherThreads) / 2;
    if (threads < 1)
        throw DeviceError(
            fmt::format("only {} more threads can be started, and a render needs {}; raise the limit of processes (ulimit -u)", startable,
                        otherThreads + 2));
    return threads;
}

}  // namespace eikonal
