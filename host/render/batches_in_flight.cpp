#include "render/batches_in_flight.h"

namespace eikonal {

BatchesInFlight::BatchesInFlight(const Context& context, WaveQueues& queues, const WaveSize& size, const RaySplitting& splitting)
    : context_(context), queues_(queues), size_(size), splitting_(splitting) {
    for (unsigned place = 0; place < size.batches; ++place) tables_.emplace_back(context);
}

Bindings BatchesInFlight::argumentsOf(const InFlight& batch) const {
    Bindings arguments = tables_[batch.place].bindings();
    arguments.set("first_path", firstPath(batch));
    return arguments;
}

/// Starts the next batch of the stream. Returns false if there is none, or no free place.
bool BatchesInFlight::admit(const BatchStream& stream) {
    if (flying_.size() == tables_.size()) return false;
    std::optional<Batch> batch = stream.next();
    if (!batch) return false;
    tables_[nextPlace_].write(context_, *batch, stream.endX, stream.endY);
    flying_.push_back({std::move(*batch), nextPlace_});
    nextPlace_ = (nextPlace_ + 1) % static_cast<unsigned>(tables_.size());
    splitting_.clearStates(context_, queues_.paths());
    return true;
}

std::optional<BatchesInFlight::Start> BatchesInFlight::begin(unsigned most, const BatchStream& stream) {
    if ((flying_.empty() || flying_.back().isBegun()) && !admit(stream)) return {};
    InFlight& last = flying_.back();
    Start start{std::min(most, last.batch.paths() - last.begun), argumentsOf(last)};
    start.arguments.set("begun", last.begun);
    last.begun += start.count;
    return start;
}

void BatchesInFlight::finish(const WaveCounts& counts, const BatchStream& stream) {
    while (!flying_.empty() && flying_.front().isBegun() && !counts[count_of_batches + flying_.front().place]) {
        stream.traced(flying_.front().batch);
        flying_.pop_front();
    }
}

QueueItems BatchesInFlight::oldestPaths() const {
    return queues_.items(Queue::path, firstPath(flying_.front()), flying_.front().batch.paths());
}

Bindings BatchesInFlight::noPaths() const {
    Bindings arguments = tables_.front().bindings();
    for (const char* name : {"begun", "first_path"}) arguments.set(name, 0u);
    return arguments;
}

}  // namespace eikonal
