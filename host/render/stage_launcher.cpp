#include "render/stage_launcher.h"

#include <chrono>

namespace eikonal {

void StageLauncher::enqueue(const Stage& stage, SlotRange slots, const Bindings& own, unsigned width) const {
    Bindings range;
    range.set("first", slots.first);
    range.set("count", slots.count);
    profile_.add(stage.name, slots.count,
                 stage.kernel.launch(context_,
                                     {&shared_.scene, &shared_.queues, &shared_.counts, &shared_.cache, &shared_.vertices, &own, &range},
                                     width, shape_.group(stage.row->form)));
}

void StageLauncher::warmUp(Stages& stages, const Bindings& nothing, unsigned width) const {
    const Buffer unused(context_, 1024, "an unused argument");
    Bindings own = nothing;
    for (const char* name : {"shading_pass", "pass_slots", "representatives", "point_count"}) own.set(name, 0u);
    for (const char* name : {"splat_x", "splat_y", "splat_width", "splat_height"}) own.set(name, 0u);
    for (const char* name : {"film", "splat", "survey_points", "survey_normals", "survey_texels", "survey_weights"}) own.set(name, unused);
    for (Stage& stage : stages.all()) {
        const auto start = std::chrono::steady_clock::now();
        enqueue(stage, {}, own, width);
        context_.finish();
        stage.firstLaunchSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        stages.stepDone(stage);
    }
    profile_.collect();
    profile_.reset();
}

}  // namespace eikonal
