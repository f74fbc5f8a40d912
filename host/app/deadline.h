#pragma once
// When a render ends before it has all samples.

#include "clock.h"

#include <atomic>
#include <optional>

namespace eikonal {

struct OutputOptions;
struct MemoryPlan;

/// Whether and how soon a render has to end: by a signal, by --time-limit, which counts rendering alone, or by --deadline, which counts
/// everything from the start of the program until the files are written. Begins to count when it is made, just before rendering.
class Deadline {
public:
    Deadline(const OutputOptions& options, const MemoryPlan& plan);
    /// The option that ends the render, such as "--time-limit"; null: there is none.
    const char* option() const { return option_; }
    /// By how many seconds --deadline is missed even if rendering takes no time; 0 if it is not.
    double missedBy() const { return missedBy_; }

    /// Whether to begin no more paths: on a signal or when the time is over, but that waits a little until every pixel has a sample.
    bool isOver() const;
    /// Whether to abandon paths. Asked by one thread.
    bool isFinal();
    /// Seconds until the time is over, if there is a limit; at least 0.
    std::optional<double> secondsLeft() const;
    std::atomic<bool> isWhole = false;   ///< every pixel has a sample

private:
    const char* option_ = nullptr;
    std::optional<double> limit_;        ///< seconds from the start of time_
    double missedBy_ = 0;
    const Stopwatch time_;
    std::optional<double> signalled_;
};

}  // namespace eikonal
