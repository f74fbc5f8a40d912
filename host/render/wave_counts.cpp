#include "render/wave_counts.h"

#include <numeric>

namespace eikonal {

std::uint64_t raysOf(const WaveCounts& counts) {
    return std::accumulate(counts.begin() + count_of_batches, counts.end(), std::uint64_t{0});
}

Segments::Segments(std::span<const cl_uint> counts, unsigned group) {
    for (uint next_queue = first; next_queue <= last; ++next_queue) {
        ranges_[next_queue] = {slots_, counts[next_queue]};
        slots_ += (counts[next_queue] + group - 1) / group * group;
    }
}

WaveCounter::WaveCounter(const Context& context, Profile& profile)
    : context_(context), profile_(profile), counts_(context, sizeof(WaveCounts), "counts"),
      cursors_(context, sizeof(WaveCounts), "cursors"), shadowCount_(context, sizeof(cl_uint), "shadow rays") {
    bindings_.set("counts", counts_);
    bindings_.set("cursors", cursors_);
    bindings_.set("shadow_count", shadowCount_);
}

void WaveCounter::begin() {
    shadowCount_.clear(context_, 0, sizeof shadowRays_);
    shadowRays_ = 0;
}

void WaveCounter::clear() {
    counts_.clear(context_, 0, sizeof(WaveCounts));
    cursors_.clear(context_, 0, sizeof(WaveCounts));
}

void WaveCounter::startReading() {
    const auto read = [&](const Buffer& from, void* to, size_t bytes, cl_event* done) {
        check(clEnqueueReadBuffer(context_.queue(), from.handle(), CL_FALSE, 0, bytes, to, 0, nullptr, done), "reading the counts");
    };
    cl_event done = nullptr;
    read(shadowCount_, &shadowRead_, sizeof shadowRead_, nullptr);
    read(counts_, read_.data(), sizeof read_, &done);
    arrived_ = Owned<cl_event, clReleaseEvent>(done);
}

WaveCounts WaveCounter::wait(const std::function<void()>& meanwhile) {
    context_.flush();
    meanwhile();
    const cl_event arrived = arrived_;
    check(clWaitForEvents(1, &arrived), "waiting for the counts");
    addShadowRays();
    profile_.rays += raysOf(read_);
    return read_;
}

void WaveCounter::end() {
    shadowCount_.read(context_, &shadowRead_, sizeof shadowRead_);
    addShadowRays();
}

void WaveCounter::addShadowRays() {
    profile_.shadowRays += shadowRead_ - shadowRays_;
    shadowRays_ = shadowRead_;
}

}  // namespace eikonal
