#pragma once
// A render while it goes on, for those who look at it from other threads, and what they ask of it.

#include "film/noise.h"
#include "image/film_image.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace eikonal {

/// Seconds of each of several things, in order.
using NamedSeconds = std::vector<std::pair<std::string, double>>;

struct LiveState {
    std::string scene;                              ///< its file
    std::string phase = "loading";                  ///< loading, rendering, paused, stopping, or how it ended
    bool hasEnded = false;                          ///< the files are written, or never will be
    double fraction = 0, seconds = 0, samples = 0;  ///< as in Progress; samples: the mean per pixel
    unsigned samplesInAll = 0;                      ///< the maximum per pixel
    std::optional<double> secondsLeft;
    std::optional<double> targetError;
    std::string metric;  ///< what the errors are
    std::string doubt;   ///< why the last estimate is not reliable; empty: it is
    struct Error {
        double seconds, error, low, high;
    };
    std::vector<Error> errors;               ///< estimates so far
    NamedSeconds steps, stages;              ///< before the first ray; of the device, since then
    std::vector<std::string> files;          ///< that are written
    unsigned saves = 0;                      ///< how often they were, on demand
    std::string problem;                     ///< of the last time
    std::shared_ptr<const FilmImage> image;  ///< null: none yet
    std::uint64_t imageNumber = 0;           ///< changes with the image
    std::uint64_t number = 0;                ///< changes with anything
};

/// Thread-safe.
class LiveRender {
public:
    enum class Wish { pause, goOn, stop, save, end };

    // For the render
    /// Changes the state, and wakes those who wait for news.
    void update(const std::function<void(LiveState&)>& change);
    /// The same for what changes often: they are woken a few times a second.
    void note(const std::function<void(LiveState&)>& change);
    void showImage(std::shared_ptr<const FilmImage> image, const ErrorEstimate& error, double seconds);
    bool isStopAsked() const;
    bool isPaused() const;
    /// Whether the files are to be written now; asked once for each wish.
    bool takeSave();
    /// Waits while it is to be paused, calling `meanwhile` some times a second. Returns the seconds that it took.
    double waitWhilePaused(const std::function<void()>& meanwhile, const std::function<bool()>& isOver);
    /// Waits until the end is asked for, or isOver.
    void waitForEnd(const std::function<bool()>& isOver);
    /// Those who look are given a moment to see the last image.
    void waitForLastLook();
    /// From now on nothing waits.
    void close();

    // For those who look
    /// The state, once its number differs from `known`, or after some seconds.
    LiveState stateAfter(std::uint64_t known) const;
    LiveState state() const;
    /// False: too late, or too early.
    bool wish(Wish wish);
    void noteLook(std::uint64_t imageNumber) const;

private:
    const LiveState& told() const;   ///< locked
    mutable std::mutex mutex_;
    mutable std::condition_variable change_;
    LiveState state_;
    bool paused_ = false, stop_ = false, save_ = false, end_ = false, closed_ = false;
    std::chrono::steady_clock::time_point notedAt_;           ///< when note() woke them
    mutable std::chrono::steady_clock::time_point lookedAt_;  ///< the last time
    mutable bool endTold_ = false;                             ///< that the render has ended
    mutable std::uint64_t lookedOn_ = 0;                      ///< number of the last image looked at
};

}  // namespace eikonal
