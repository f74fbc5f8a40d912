#include "render/profile.h"

namespace eikonal {

void Profile::add(const std::string& stage, std::uint64_t slots, cl_event event) {
    const std::lock_guard lock(mutex_);
    StageProfile& s = stages_[stage];
    ++s.launches;
    s.slots += slots;
    if (event) pending_.push_back({&s, Owned<cl_event, clReleaseEvent>(event)});
}

void Profile::join(const Profile& other) {
    const std::map<std::string, StageProfile> others = other.stages();
    const std::lock_guard lock(mutex_);
    for (const auto& [name, more] : others) {
        StageProfile& stage = stages_[name];
        stage.launches += more.launches;
        stage.slots += more.slots;
        stage.seconds += more.seconds;
    }
    rays += other.rays;
    shadowRays += other.shadowRays;
    paths += other.paths;
}

std::map<std::string, StageProfile> Profile::stages() const {
    const std::lock_guard lock(mutex_);
    return stages_;
}

void Profile::readFirst() {
    const Pending& p = pending_.front();
    cl_ulong start = 0, end = 0;
    check(clGetEventProfilingInfo(p.event, CL_PROFILING_COMMAND_START, sizeof start, &start, nullptr), "reading a profile");
    check(clGetEventProfilingInfo(p.event, CL_PROFILING_COMMAND_END, sizeof end, &end, nullptr), "reading a profile");
    p.stage->seconds += static_cast<double>(end - start) * 1e-9;
    pending_.pop_front();
}

void Profile::collectFinished() {
    const std::lock_guard lock(mutex_);
    for (; !pending_.empty(); readFirst()) {
        cl_int status = CL_COMPLETE;
        check(clGetEventInfo(pending_.front().event, CL_EVENT_COMMAND_EXECUTION_STATUS, sizeof status, &status, nullptr),
              "reading a profile");
        if (status != CL_COMPLETE) return;
    }
}

void Profile::collect() {
    const std::lock_guard lock(mutex_);
    while (!pending_.empty()) readFirst();
}

void Profile::reset() {
    const std::lock_guard lock(mutex_);
    pending_.clear();
    stages_.clear();
    rays = shadowRays = paths = 0;
}

}  // namespace eikonal
