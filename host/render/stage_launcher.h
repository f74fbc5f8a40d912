#pragma once
// Launching the stages of a wave.

#include "render/profile.h"
#include "render/stages.h"

namespace eikonal {

/// What all launches of a wave have in common.
class StageLauncher {
public:
    /// scene, queues, counts: what these bind for every stage, read at each launch. group: slots of a group. All of them outlive this.
    StageLauncher(const Context& context, const Bindings& scene, const Bindings& queues, const Bindings& counts, unsigned group,
                  Profile& profile)
        : context_(context), scene_(scene), queues_(queues), counts_(counts), group_(group), profile_(profile) {}

    /// Enqueues the stage over these slots, unless there are none. `own`: further arguments.
    void launch(const Stage& stage, SlotRange slots, const Bindings& own = {}) const {
        if (slots.count) enqueue(stage, slots, own);
    }
    /// Runs every stage once over nothing, so that an implementation that compiles at the first launch does it now.
    /// nothing: as `own`, for any stage.
    void warmUp(Stages& stages, const Bindings& nothing) const;

private:
    void enqueue(const Stage& stage, SlotRange slots, const Bindings& own) const;

    const Context& context_;
    const Bindings &scene_, &queues_, &counts_;
    unsigned group_;
    Profile& profile_;
};

}  // namespace eikonal
