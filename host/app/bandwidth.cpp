#include "app/bandwidth.h"

#include "pack/material_slots.h"
#include "render/profile.h"
#include "render/wave_queues.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace eikonal {
namespace {

/// Words of the parameters of the BSDF that `stage` shades; of the largest BSDF for other stages.
int parameterWords(const StageProgram& stage, const Features& features) {
    const uint next = stage.over >= light_hits ? (stage.over - light_hits) % next_values : stage.over;
    const uint words = bsdfParameterWords(next, features.has(Feature::SPECTRAL));
    return words ? static_cast<int>(words) : bsdfWords(features);
}

/// Whether the BSDF that `stage` shades uses random walks between layers; such BSDFs have a parameter max_depth.
bool walksBetweenLayers(const StageProgram& stage) {
    bool walks = false;
#define IS_LIMIT(q, type, name, FEATURE) walks |= std::string_view(#name) == "max_depth" && stage.over == next_##q;
#define LOOK_AT(bsdf, FEATURE, PARAMETERS) PARAMETERS(IS_LIMIT, bsdf)
    BSDFS(LOOK_AT)
#undef LOOK_AT
#undef IS_LIMIT
    return walks;
}

int wordsOf(Queue queue, const StageProgram& stage, const Features& features) {
    const QueueList blocks{Queue::pixels, Queue::film, Queue::splat, Queue::cached, Queue::vertex, Queue::grid, Queue::counts};
    if (blocks.has(queue)) return 0;
    const QueueLayout layout = itemLayout(queue, features);
    switch (queue) {
        case Queue::path: return stage.over == each_sample ? layout.words : 2 * layout.field("L").words;
        case Queue::hit: return layout.words - bsdfWords(features) + parameterWords(stage, features);
        case Queue::walk: return walksBetweenLayers(stage) ? layout.words : 0;
        default: return layout.words;
    }
}

}  // namespace

double queueBytesPerSlot(const StageProgram& stage, const Features& features) {
    if (stage.over == each_pixel) return 0;
    int read = 0, written = 0, widest = 0;
    bool chooses = false;
    for (Queue queue : stage.row->reads) read += wordsOf(queue, stage, features);
    for (Queue queue : stage.row->writes) {
        const int words = wordsOf(queue, stage, features);
        written += words;
        widest = std::max(widest, words);
        chooses |= static_cast<size_t>(queue) < queueCount && rowOf(queue).placement == Placement::dense;
    }
    return (read + (chooses ? widest : written)) * static_cast<double>(sizeof(cl_uint));
}

double queueCopyRate(const Context& context, Compiler& compiler, const StageShape& shape) {
    constexpr unsigned words = 16;
    std::string text = "#include \"stages/stage.clh\"\n"
                       "#define COPY_QUEUE(TABLE, ARGUMENT) ARGUMENT(__global const uint *, from) ARGUMENT(__global uint *, to)\n"
                       "STAGE(copy_queue, COPY_QUEUE) {\n    FOR_EACH_SLOT_OF_GROUP(i, count) {\n";
    for (unsigned w = 0; w < words; ++w) text += fmt::format("        to[{0}ul * capacity + i] = from[{0}ul * capacity + i];\n", w);
    BuildSettings settings;
    settings.constants = {{"LOCAL_SIZE", static_cast<int>(shape.localSize)},
                          {"ITEMS_PER_WORK_ITEM", static_cast<int>(shape.itemsPerWorkItem)},
                          {"WIDENS_GROUPS", shape.widensGroups}};
    const Kernel copy(compiler.build(text + "    }\n}\n", "copy_queue", settings));

    const unsigned slots = shape.padded(1u << 20), capacity = slots + shape.group();
    const size_t bytes = static_cast<size_t>(capacity) * words * sizeof(cl_uint);
    const Buffer from(context, bytes, "a queue to copy from"), to(context, bytes, "a queue to copy to");
    Bindings bindings;
    bindings.set("from", from);
    bindings.set("to", to);
    bindings.set("capacity", capacity);
    bindings.set("path_capacity", 0u);
    bindings.set("count", slots);
    double best = 0;
    for (int i = 0; i < 5; ++i) {
        Profile profile;
        profile.add("copy", slots, copy.launch(context, {&bindings}, slots, shape.group()));
        context.finish();
        profile.collect();
        best = std::max(best, 2.0 * slots * words * sizeof(cl_uint) / std::max(profile.stages().at("copy").seconds, 1e-9));
    }
    compiler.keep(copy.program());
    return best;
}

}  // namespace eikonal
