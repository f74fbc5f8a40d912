#pragma once
// Launches the stages of a wave.

#include "render/profile.h"
#include "render/stages.h"

namespace eikonal {

/// The arguments that all launches of a wave share.
class StageLauncher {
public:
    /// Bindings for every stage, read at each launch.
    struct Shared {
        const Bindings &scene, &queues, &counts, &cache, &vertices;
    };
    /// All must outlive this object.
    StageLauncher(const Context& context, const Shared& shared, const StageShape& shape, Profile& profile)
        : context_(context), shared_(shared), shape_(shape), profile_(profile) {}

    /// Enqueues the stage over these slots; does nothing if there are none. `own`: further arguments.
    void launch(const Stage& stage, SlotRange slots, const Bindings& own = {}) const {
        if (slots.count) enqueue(stage, slots, own, slots.count);
    }
    /// Runs every stage once over no slots, so that implementations that compile at the first launch do it now. `nothing`: the `own`
    /// arguments of any stage. width: in so many dead slots.
    void warmUp(Stages& stages, const Bindings& nothing, unsigned width) const;

private:
    void enqueue(const Stage& stage, SlotRange slots, const Bindings& own, unsigned width) const;

    const Context& context_;
    Shared shared_;
    const StageShape& shape_;
    Profile& profile_;
};

}  // namespace eikonal
