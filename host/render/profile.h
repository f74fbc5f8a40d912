#pragma once
// Profile of the stages: launches, slots and device time of each.

#include "device/check.h"

#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <string>

namespace eikonal {

/// Totals of one stage.
struct StageProfile {
    std::uint64_t launches = 0;
    std::uint64_t slots = 0;     ///< slots of all launches
    double seconds = 0;          ///< device time
};

/// Collects the events of launches. Without profiling there are no events, so only launches and slots are counted. Its functions may be
/// called at any time by any thread.
class Profile {
public:
    /// Takes over `event`, which may be null.
    void add(const std::string& stage, std::uint64_t slots, cl_event event);
    /// Reads the clocks of the events that have ended; without a device that is idle the last ones may be left.
    void collectFinished();
    /// Reads the clocks of all events so far; the device must be idle.
    void collect();
    void reset();
    /// Adds what another has counted, whose device must be idle.
    void join(const Profile& other);

    std::map<std::string, StageProfile> stages() const;
    std::uint64_t rays = 0;      ///< without dead slots
    std::uint64_t shadowRays = 0;
    std::uint64_t paths = 0;

private:
    void readFirst();
    struct Pending { StageProfile* stage; Owned<cl_event, clReleaseEvent> event; };
    mutable std::mutex mutex_;
    std::map<std::string, StageProfile> stages_;
    std::deque<Pending> pending_;   ///< in the order of the launches
};

}  // namespace eikonal
