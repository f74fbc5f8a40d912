#pragma once
// The stages of a scene as kernels: built, compiled to the end, and ready to run.

#include "device/kernel.h"
#include "pack/tables.h"
#include "render/stage_programs.h"

#include <ranges>
#include <string>
#include <vector>

namespace eikonal {

/// Neighbouring slots of a queue.
struct SlotRange { unsigned first = 0, count = 0; };

/// How stages are laid over a device. None of this changes a bit of the image.
struct StageShape {
    unsigned localSize = 1;    ///< work-items in a group, a power of two
    unsigned itemsPerWorkItem = 64; ///< slots that a work-item handles, a power of two: on a CPU SIMD is inside of the work-item,
    bool widensGroups = false; ///< unless this is set; then a work-item of a straight-line stage handles one (kernels/stages/stage.clh)
    unsigned wavePaths = 131008;  ///< rays in flight: a path is one, or more with trees of rays
    unsigned batches = 8;      ///< whose paths are in flight together, at most MOST_BATCHES: the last paths of one leave room for the next
    /// Slots of a group: segments of queues begin at multiples of it.
    unsigned group() const { return localSize * itemsPerWorkItem; }
    /// `slots`, rounded up to whole groups.
    unsigned padded(unsigned slots) const { return (slots + group() - 1) / group() * group(); }
    /// What measured best for a kind of device (docs/performance.md).
    static StageShape forDevice(const DeviceInfo& device);
};

/// What every program of a scene is built with: its features, and the constants of the shape.
BuildSettings completeSettings(BuildSettings settings, const PackedScene& scene, const StageShape& shape);

/// A stage that a scene requires, ready to run. shade_hits is there once for each BSDF.
struct Stage {
    std::string name;        ///< as in StageProgram, like the next two
    const StageRow* row;
    uint over;
    Kernel kernel;
    double compileSeconds = 0, firstLaunchSeconds = 0;
};

/// Which of a scene's stages to build: every `of`-th, from the `index`-th on.
struct StagePart { unsigned index = 0, of = 1; };

class Stages {
public:
    Stages(Compiler& compiler, const PackedScene& scene, const StageShape& shape, BuildSettings settings, StagePart part = {});

    /// How many of the stages that a scene requires are not in the compiler's cache.
    static int missing(const Compiler& compiler, const PackedScene& scene, const StageShape& shape, BuildSettings settings);

    /// The stages that run over the slots or items `first` to `last` of stage_items or next_queue, in the order of STAGES.
    auto over(uint first, uint last) const {
        return std::views::filter(stages_, [first, last](const Stage& stage) { return stage.over >= first && stage.over <= last; });
    }
    auto over(uint items) const { return over(items, items); }
    /// Throws std::out_of_range if it is not among them.
    const Stage& find(StageName id) const;
    /// What they are built with.
    const Features& features() const { return features_; }
    /// Keeps their programs in the compiler's cache, once each has been launched (Compiler::keep).
    void keep(const Compiler& compiler) const;
    std::vector<Stage>& all() { return stages_; }
    const std::vector<Stage>& all() const { return stages_; }

private:
    Features features_;
    std::vector<Stage> stages_;
};

}  // namespace eikonal
