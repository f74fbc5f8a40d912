#pragma once
// The stages of a scene as compiled kernels.

#include "device/kernel.h"
#include "pack/tables.h"
#include "render/stage_programs.h"

#include <functional>
#include <ranges>
#include <string>
#include <vector>

namespace eikonal {

/// A range of slots of a queue.
struct SlotRange { unsigned first = 0, count = 0; };

/// How stages are mapped to a device. No setting changes the image.
struct StageShape {
    unsigned localSize = 1;    ///< work-items per group, a power of two
    unsigned itemsPerWorkItem = 64; ///< slots per work-item, a power of two; on a CPU the compiler vectorises over them
    bool widensGroups = false; ///< the compiler vectorises over work-items: those of straight-line stages take one slot (stages/stage.clh)
    unsigned wavePaths = 131008;  ///< rays in flight; one per path without ray splitting
    unsigned batches = 8;      ///< batches in flight, at most MOST_BATCHES; paths of the next fill the slots that ended paths leave
    /// Slots per group. Segments of queues begin at multiples of it.
    unsigned group() const { return localSize * itemsPerWorkItem; }
    /// Slots per group of the stages of a form.
    unsigned group(StageForm form) const {
        return form == StageForm::counting && itemsPerWorkItem > 1 ? COUNTING_GROUPS * group() : group();
    }
    /// `slots`, rounded up to whole groups.
    unsigned padded(unsigned slots) const { return (slots + group() - 1) / group() * group(); }
    /// The fastest shape for a kind of device, as measured (docs/performance.md).
    static StageShape forDevice(const DeviceInfo& device);
};

/// The build settings of a scene's programs: its features, and the constants of the shape.
BuildSettings completeSettings(BuildSettings settings, const PackedScene& scene, const StageShape& shape);

/// A stage that a scene requires, ready to run. There is one shade_hits per BSDF.
struct Stage {
    std::string name;        ///< as in StageProgram, like the next two
    const StageRow* row;
    uint over;
    Kernel kernel;
    double compileSeconds = 0, firstLaunchSeconds = 0;
};

/// A part of a scene's stages: every `of`-th, from the `index`-th on.
struct StagePart { unsigned index = 0, of = 1; };

class Stages {
public:
    /// stepDone: called when a kernel that is not in the cache has been built, and when it has been launched for the first time, which may
    /// compile the rest of it. May be empty.
    Stages(Compiler& compiler, const PackedScene& scene, const StageShape& shape, BuildSettings settings, StagePart part = {},
           std::function<void()> stepDone = {});

    /// The number of required stages that are not in the compiler's cache.
    static int missing(const Compiler& compiler, const PackedScene& scene, const StageShape& shape, BuildSettings settings);

    /// The stages that run over the slots or items `first` to `last` of stage_items or next_queue, in the order of STAGES.
    auto over(uint first, uint last) const {
        return std::views::filter(stages_, [first, last](const Stage& stage) { return stage.over >= first && stage.over <= last; });
    }
    auto over(uint items) const { return over(items, items); }
    /// Throws std::out_of_range if the scene does not require the stage.
    const Stage& find(StageName id) const;
    /// The features that the stages are built with.
    const Features& features() const { return features_; }
    /// Stores the programs in the cache. Call it after each has been launched (Compiler::keep).
    void keep(const Compiler& compiler) const;
    /// Tells of a step, unless the stage comes from the cache.
    void stepDone(const Stage& stage) const;
    std::vector<Stage>& all() { return stages_; }
    const std::vector<Stage>& all() const { return stages_; }

private:
    Features features_;
    std::vector<Stage> stages_;
    std::function<void()> stepDone_;
};

}  // namespace eikonal
