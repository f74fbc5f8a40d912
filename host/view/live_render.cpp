#include "view/live_render.h"

#include <utility>

namespace eikonal {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// How long a request waits for news.
constexpr auto newsPatience = 10s;
/// How often progress is news.
constexpr auto noteInterval = 300ms;
/// Errors that are kept: with more, every second one is dropped.
constexpr std::size_t mostErrors = 600;

void LiveRender::update(const std::function<void(LiveState&)>& change) {
    const std::lock_guard lock(mutex_);
    change(state_);
    ++state_.number;
    change_.notify_all();
}

void LiveRender::note(const std::function<void(LiveState&)>& change) {
    const std::lock_guard lock(mutex_);
    change(state_);
    if (Clock::now() - notedAt_ < noteInterval) return;
    notedAt_ = Clock::now();
    ++state_.number;
    change_.notify_all();
}

void LiveRender::showImage(std::shared_ptr<const FilmImage> image, const ErrorEstimate& error, double seconds) {
    update([&](LiveState& state) {
        state.image = std::move(image);
        ++state.imageNumber;
        state.doubt = error.doubt;
        state.errors.push_back({seconds, error.error, error.low, error.high});
        if (state.errors.size() < mostErrors) return;
        std::size_t kept = 0;
        for (std::size_t i = 1; i < state.errors.size(); i += 2) state.errors[kept++] = state.errors[i];
        state.errors.resize(kept);
    });
}

bool LiveRender::isStopAsked() const {
    const std::lock_guard lock(mutex_);
    return stop_;
}

bool LiveRender::isPaused() const {
    const std::lock_guard lock(mutex_);
    return paused_;
}

bool LiveRender::takeSave() {
    const std::lock_guard lock(mutex_);
    return std::exchange(save_, false);
}

double LiveRender::waitWhilePaused(const std::function<void()>& meanwhile, const std::function<bool()>& isOver) {
    std::unique_lock lock(mutex_);
    if (!paused_) return 0;
    const auto start = Clock::now();
    while (paused_ && !stop_ && !isOver()) {
        lock.unlock();
        meanwhile();
        lock.lock();
        change_.wait_for(lock, 100ms, [&] { return !paused_ || stop_ || save_; });
    }
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void LiveRender::waitForEnd(const std::function<bool()>& isOver) {
    std::unique_lock lock(mutex_);
    while (!end_ && !isOver()) change_.wait_for(lock, 100ms, [&] { return end_; });
}

void LiveRender::waitForLastLook() {
    std::unique_lock lock(mutex_);
    if (Clock::now() - lookedAt_ > 5s) return;  // no page is open
    change_.wait_for(lock, 2s, [&] { return endTold_ && lookedOn_ == state_.imageNumber; });
}

void LiveRender::close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    change_.notify_all();
}

LiveState LiveRender::stateAfter(std::uint64_t known) const {
    std::unique_lock lock(mutex_);
    lookedAt_ = Clock::now();
    change_.wait_for(lock, newsPatience, [&] { return closed_ || state_.number != known; });
    return told();
}

LiveState LiveRender::state() const {
    const std::lock_guard lock(mutex_);
    return told();
}

const LiveState& LiveRender::told() const {
    lookedAt_ = Clock::now();
    endTold_ |= state_.hasEnded;
    change_.notify_all();
    return state_;
}

bool LiveRender::wish(Wish wish) {
    const std::lock_guard lock(mutex_);
    if (wish == Wish::end) {
        end_ = state_.hasEnded;
        change_.notify_all();
        return end_;
    }
    if (state_.hasEnded || stop_ || (state_.phase != "rendering" && state_.phase != "paused")) return false;
    switch (wish) {
        case Wish::pause:
            paused_ = true;
            break;
        case Wish::goOn:
            paused_ = false;
            break;
        case Wish::save:
            save_ = true;
            break;
        default:
            stop_ = true;
            break;
    }
    state_.phase = stop_ ? "stopping" : paused_ ? "paused" : "rendering";
    ++state_.number;
    change_.notify_all();
    return true;
}

void LiveRender::noteLook(std::uint64_t imageNumber) const {
    const std::lock_guard lock(mutex_);
    lookedOn_ = imageNumber;
    change_.notify_all();
}

}  // namespace eikonal
