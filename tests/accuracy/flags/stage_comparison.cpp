#include "flags/stage_comparison.h"

#include "kernels/stage.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace eikonal {
namespace {

constexpr unsigned side = 32, samples = 16, paths = side * side * samples;

float asFloat(uint word) {
    float value;
    std::memcpy(&value, &word, sizeof value);
    return value;
}
bool isNormalOrZero(float x) { return x == 0 || std::fpclassify(x) == FP_NORMAL; }

bool hasField(const QueueWords& q, const char* name) {
    return std::ranges::any_of(q.layout().fields, [name](const FieldLayout& f) { return f.name == name && f.words > 0; });
}

bool isAlive(const QueueWords& q, size_t i) {
    for (const char* end : {"t_max", "t"})
        if (hasField(q, end) && !(q.get<float>(end, i) >= 0)) return false;
    return !hasField(q, "path") || q.get<uint>("path", i) < paths;
}

/// Where the item of each path is; by slot, if items do not know their path.
std::map<size_t, size_t> itemsOf(const QueueWords& q) {
    std::map<size_t, size_t> slots;
    const bool byPath = hasField(q, "path");
    for (size_t i = 0; i < q.capacity(); ++i)
        if (isAlive(q, i)) slots[byPath ? q.get<uint>("path", i) : i] = i;
    return slots;
}

bool isChanged(const QueueWords& before, const QueueWords& after, size_t i) {
    for (int w = 0; w < after.layout().words; ++w)
        if (before.word(w, i) != after.word(w, i)) return true;
    return false;
}

/// Compares words [slot, slot + words) of two items as one vector. Returns false if they are not floats, and differ.
bool compareWords(const QueueWords& a, size_t i, const QueueWords& b, size_t j, int slot, int words, UlpTally& tally) {
    double largest = 0, difference = 0;
    for (int w = slot; w < slot + words; ++w) {
        const float x = asFloat(a.word(w, i)), y = asFloat(b.word(w, j));
        if (a.word(w, i) == b.word(w, j)) {
            if (isNormalOrZero(x)) largest = std::max(largest, std::fabs(static_cast<double>(x)));
            continue;
        }
        if (!isNormalOrZero(x) || !isNormalOrZero(y)) return false;
        largest = std::max(largest, std::fabs(static_cast<double>(x)));
        difference = std::max(difference, std::fabs(static_cast<double>(x) - static_cast<double>(y)));
    }
    tally.add(difference / unitInLastPlace(largest));
    return true;
}

/// Fields of the film that hold rounding errors, or squares of differences: relative to themselves, these have no correct digits.
bool isDifference(const std::string& field) {
    for (const char* name : {"compensation", "weight_excess", "spread", "half_square", "quarter_square", "eighth_square"})
        if (field == name) return true;
    return false;
}

/// Two items, field by field; the parameters of BSDFs, which have no types here, word by word. Returns whether they decide alike.
bool compareItems(const QueueWords& a, size_t i, const QueueWords& b, size_t j, UlpTally& tally) {
    UlpTally own = tally;
    int end = 0;
    for (const FieldLayout& f : a.layout().fields) {
        end = std::max(end, f.slot + f.words);
        const bool isWhole = f.type == "uint" || f.type == "int";
        for (int w = 0; isWhole && w < f.words; ++w)
            if (a.word(f.slot + w, i) != b.word(f.slot + w, j)) return false;
        if (!isWhole && f.words > 0 && !isDifference(f.name) && !compareWords(a, i, b, j, f.slot, f.words, own)) return false;
    }
    for (int w = end; w < a.layout().words; ++w)
        if (!compareWords(a, i, b, j, w, 1, own)) return false;
    tally = own;
    return true;
}

class Comparison {
public:
    Comparison(const PackedScene& scene, const std::vector<std::string>& flagSets)
        : flagSets_(flagSets), bench_(scene, paths, false, side * side) {}

    std::vector<StageFigures> run() {
        bench_.set({{5, 5}, {{0, 0, 0, samples}}}, static_cast<int>(side), static_cast<int>(side));
        runOver(each_sample, {0, paths});
        for (unsigned rays = paths; rays > 0;) rays = bounce(rays);
        runOver(each_pixel, {0, side * side});
        std::vector<StageFigures> all;
        for (const auto& [key, figures] : figures_) all.push_back(figures);
        return all;
    }

private:
    /// As Wave::trace. Returns the rays of the next bounce.
    unsigned bounce(unsigned rays) {
        for (const QueueRow& queue : queueTable)
            if (queue.id != Queue::ray && queue.id != Queue::path) bench_.clear(queue.name);
        bench_.clear("next_ray");
        bench_.resetCounters();
        runOver(each_ray, {0, rays});
        runOver(each_intersection, {0, rays});
        const auto counts = bench_.counts();
        for (uint next : {next_miss, next_emission}) runOver(next, {0, counts[next]});
        const Segments segments = bench_.segments();
        for (uint next = Segments::first; next <= Segments::last; ++next)
            if (counts[next]) runOver(next, segments[next]);
        runOver(each_shadow, {0, segments.slots()});
        bench_.write("ray", bench_.read("next_ray"));
        return segments.slots();
    }

    void runOver(uint items, SlotRange slots) {
        if (slots.count == 0) return;
        for (const StageProgram& program : stagePrograms())
            if (program.over == items && program.isRequired(bench_.scene().features, bench_.scene().constants)) runStage(program, slots);
    }

    void runStage(const StageProgram& program, SlotRange slots) {
        const StageBench::State before = bench_.save();
        const std::vector<QueueWords> old = read(program);
        run(program, slots, flagSets_.front());
        const std::vector<QueueWords> first = read(program);
        const StageBench::State after = bench_.save();
        for (size_t k = 1; k < flagSets_.size(); ++k) {
            bench_.restore(before);
            run(program, slots, flagSets_[k]);
            const std::vector<QueueWords> other = read(program);
            StageFigures& figures = figures_[{program.name, k}];
            figures.stage = program.name;
            figures.flags = flagSets_[k];
            for (size_t q = 0; q < first.size(); ++q) compareQueues(old[q], first[q], other[q], figures);
        }
        bench_.restore(after);
    }

    void run(const StageProgram& program, SlotRange slots, const std::string& flags) {
        bench_.setMathFlags(flags);
        bench_.run(program.name, slots.count, slots.first);
    }

    /// The queues that the stage writes, but for its own memory and counters.
    std::vector<QueueWords> read(const StageProgram& program) const {
        std::vector<QueueWords> queues;
        for (Queue queue : program.row->writes)
            if (queue != Queue::counts && queue != Queue::walk) queues.push_back(bench_.read(nameOf(queue)));
        return queues;
    }

    static void compareQueues(const QueueWords& old, const QueueWords& first, const QueueWords& other, StageFigures& figures) {
        const auto items = itemsOf(first), others = itemsOf(other);
        for (const auto& [key, i] : items) {
            const auto found = others.find(key);
            const bool isInBoth = found != others.end();
            if (!isChanged(old, first, i) && (!isInBoth || !isChanged(old, other, found->second))) continue;
            ++figures.items;
            if (!isInBoth || !compareItems(first, i, other, found->second, figures.floats)) ++figures.decided;
        }
        for (const auto& [key, i] : others)
            if (!items.count(key) && isChanged(old, other, i)) {
                ++figures.items;
                ++figures.decided;
            }
    }

    const std::vector<std::string>& flagSets_;
    StageBench bench_;
    std::map<std::pair<std::string, size_t>, StageFigures> figures_;
};

}  // namespace

std::vector<StageFigures> compareStages(const PackedScene& scene, const std::vector<std::string>& flagSets) {
    return Comparison(scene, flagSets).run();
}

}  // namespace eikonal
