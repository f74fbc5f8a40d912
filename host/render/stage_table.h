#pragma once
// STAGES, SURVEYS and QUEUES (include/eikonal) as tables. The wave, its queues, the bench and the tests read them.

#include "eikonal/queues.h"
#include "eikonal/stages.h"
#include "feature_set.h"
#include "pack/scene_constants.h"

#include <algorithm>
#include <array>
#include <concepts>

namespace eikonal {

/// Every queue, in the order of QUEUES; then the other data that stages read and write.
enum class Queue : unsigned char {
#define QUEUE_ID(q, FIELDS, ITEMS, FEATURE) q,
    QUEUES(QUEUE_ID)
#undef QUEUE_ID
    next_ray, pixels, film, splat, cached, vertex, grid, counts
};
constexpr size_t queueCount = static_cast<size_t>(Queue::next_ray);

/// An ordered list of up to eight queues.
class QueueList {
public:
    constexpr QueueList() = default;
    constexpr QueueList(std::same_as<Queue> auto... queues) : queues_{queues...}, count_(sizeof...(queues)) {}
    constexpr const Queue* begin() const { return queues_.data(); }
    constexpr const Queue* end() const { return begin() + count_; }
    constexpr bool has(Queue queue) const { return std::find(begin(), end(), queue) != end(); }

private:
    std::array<Queue, 8> queues_{};
    size_t count_ = 0;
};

/// What a stage or queue requires of a scene to exist: nothing, a feature, one of two features, or a constant that is not 0.
class Requirement {
public:
    constexpr Requirement() = default;
    constexpr Requirement(Feature feature) : feature_(feature), other_(feature) {}
    constexpr Requirement(Feature one, Feature other) : feature_(one), other_(other) {}
    constexpr Requirement(int SceneConstants::*constant) : constant_(constant) {}
    bool isMet(const Features& features, const SceneConstants& constants) const {
        return (feature_ == Feature::none || features.has(feature_) || features.has(other_)) && (!constant_ || constants.*constant_ > 0);
    }
    constexpr bool operator==(const Requirement&) const = default;
    /// The required feature, or the first of two; Feature::none: none.
    constexpr Feature feature() const { return feature_; }

private:
    Feature feature_ = Feature::none, other_ = Feature::none;
    int SceneConstants::*constant_ = nullptr;
};

enum class StageName : unsigned char {
#define STAGE_ID(stage, ...) stage,
    STAGES(STAGE_ID) SURVEYS(STAGE_ID)
#undef STAGE_ID
};

/// How a stage treats its slots: see STAGES.
enum class StageForm : unsigned char { straight_line, tracing, counting };

struct StageRow {
    StageName id;
    const char* name;
    QueueList reads, writes;    ///< empty for surveys
    uint over;                  ///< a next_queue or a stage_items
    StageForm form;
    Requirement requirement;
};

/// How items are placed in a queue: see QUEUES.
enum class Placement : unsigned char { sparse, dense, by_path };

struct QueueRow {
    Queue id;
    const char* name;
    Placement placement;
    Requirement requirement;
};

/// STAGES, in the order in which they run.
constexpr auto stageTable = [] {
    using enum Queue;
    using enum StageForm;
    using enum Feature;
    constexpr Requirement ALWAYS, ENVIRONMENTS(&SceneConstants::environments);
#define STAGE_ROW(stage, READS, WRITES, over, form, FEATURE) \
    StageRow{StageName::stage, #stage, QueueList READS, QueueList WRITES, over, form, FEATURE},
    return std::array{STAGES(STAGE_ROW)};
#undef STAGE_ROW
}();

/// SURVEYS.
constexpr auto surveyTable = [] {
    using enum Feature;
    constexpr Requirement ENVIRONMENT_GUIDE_OR_MERGING(ENVIRONMENT_GUIDE, MERGING);
#define SURVEY_ROW(kernel, FEATURE) StageRow{StageName::kernel, #kernel, {}, {}, no_queue, StageForm::tracing, FEATURE},
    return std::array{SURVEYS(SURVEY_ROW)};
#undef SURVEY_ROW
}();

/// QUEUES.
constexpr auto queueTable = [] {
    using enum Placement;
    using enum Feature;
    constexpr Requirement ALWAYS, ENVIRONMENTS(&SceneConstants::environments);
#define QUEUE_ROW(q, FIELDS, ITEMS, FEATURE) QueueRow{Queue::q, #q, ITEMS, FEATURE},
    return std::array{QUEUES(QUEUE_ROW)};
#undef QUEUE_ROW
}();

/// The row of a stage of STAGES.
constexpr const StageRow& rowOf(StageName stage) { return stageTable.at(static_cast<size_t>(stage)); }
constexpr const QueueRow& rowOf(Queue queue) { return queueTable[static_cast<size_t>(queue)]; }
/// For example "ray" or "pixels".
constexpr const char* nameOf(Queue queue) {
    if (queue == Queue::next_ray) return "next_ray";
    if (queue == Queue::pixels) return "pixels";
    if (queue == Queue::film) return "film";
    if (queue == Queue::splat) return "splat";
    if (queue == Queue::cached) return "cached";
    if (queue == Queue::vertex) return "vertex";
    if (queue == Queue::grid) return "grid";
    return queue == Queue::counts ? "counts" : rowOf(queue).name;
}

}  // namespace eikonal
