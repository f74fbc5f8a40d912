#include "app/deadline.h"

#include "app/interrupt.h"
#include "app/options.h"
#include "render/session.h"

#include <algorithm>
#include <thread>

namespace eikonal {
namespace {

/// How long after a signal or the time limit paths in flight may still end, in seconds. Later they are abandoned.
constexpr double grace = 0.4;

/// What a render takes from its last path to its end, in seconds, from what was measured: bytes of sums that are developed, encoded and
/// compressed in a second, that are stored in a checkpoint in a second, and pixels that are denoised by a core in a second.
double secondsToEnd(const OutputOptions& options, const MemoryPlan& plan) {
    constexpr double developed = 150e6, stored = 400e6, denoised = 0.5e6, bytesOfAPixel = 100;
    const auto film = static_cast<double>(plan.film);
    double seconds = 0.05 + film / developed;
    if (!options.checkpoint.empty()) seconds += film / stored;
    if (options.denoise) seconds += film / bytesOfAPixel / denoised / std::max(std::thread::hardware_concurrency(), 1u);
    return seconds;
}

}  // namespace

Deadline::Deadline(const OutputOptions& options, const MemoryPlan& plan) {
    if (options.timeLimit) {
        option_ = "--time-limit";
        limit_ = *options.timeLimit;
    }
    if (!options.deadline) return;
    const double left = *options.deadline - secondsSinceStart() - secondsToEnd(options, plan) - grace;
    missedBy_ = std::max(-grace - left, 0.0);
    if (limit_ && *limit_ <= left) return;
    option_ = "--deadline";
    limit_ = std::max(left, 0.0);
}

bool Deadline::isOver() const { return Interrupt::signal() || (limit_ && time_.seconds() > *limit_ + (isWhole ? 0 : grace)); }

bool Deadline::isFinal() {
    if (limit_ && time_.seconds() > *limit_ + (isWhole ? 1 : 2) * grace) return true;
    if (!Interrupt::signal()) return false;
    if (!signalled_) signalled_ = time_.seconds();
    return time_.seconds() > *signalled_ + grace;
}

std::optional<double> Deadline::secondsLeft() const {
    if (!limit_) return {};
    return std::max(*limit_ - time_.seconds(), 0.0);
}

}  // namespace eikonal
