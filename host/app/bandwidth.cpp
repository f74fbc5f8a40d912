#include "app/bandwidth.h"

#include "device/kernel.h"
#include "device/layout.h"
#include "pack/material_inputs.h"
#include "render/profile.h"

#include <algorithm>
#include <sstream>

namespace eikonal {
namespace {

/// Words of the parameters of the BSDF that `stage` shades; of the largest BSDF for other stages.
int parameterWords(const std::string& stage, const Features& features) {
#define WORDS_OF(bsdf, FEATURE, PARAMETERS) if (stage == "shade_hits " #bsdf) return static_cast<int>(wordOf(slot_##bsdf::words, features.has(Feature::SPECTRAL)));
    BSDFS(WORDS_OF)
#undef WORDS_OF
    return bsdfWords(features);
}

int wordsOf(const std::string& queue, const std::string& stage, const Features& features) {
    if (queue == "pixels" || queue == "film") return 0;
    const QueueLayout layout = queueLayout(queue, features);
    if (queue == "path" && stage != "generate_rays") return 2 * layout.field("L").words;
    if (queue == "walk" && !stage.starts_with("shade_hits coated_")) return 0;
    return layout.words + (queue == "hit" ? parameterWords(stage, features) : 0);
}

}  // namespace

double queueBytesPerSlot(const std::string& stage, const Features& features) {
    int words = 0;
    const auto add = [&](const char* reads, const char* writes, bool chooses) {
        int written = 0;
        std::string queue;
        for (std::istringstream names(reads); names >> queue;) words += wordsOf(queue, stage, features);
        for (std::istringstream names(writes); names >> queue;) {
            const int of = wordsOf(queue, stage, features);
            written = chooses ? std::max(written, of) : written + of;
        }
        words += written;
    };
#define ADD_STAGE(name, reads, writes, FEATURE) \
    if (stage.substr(0, stage.find(' ')) == #name && stage != "resolve_film") add(reads, writes, stage == "route_intersections");
    STAGES(ADD_STAGE)
#undef ADD_STAGE
    return words * static_cast<double>(sizeof(cl_uint));
}

double queueCopyRate(const Context& context, Compiler& compiler, const StageShape& shape) {
    constexpr unsigned words = 16;
    std::string text = "#include \"stages/stage.clh\"\n#define COPY_QUEUE(TABLE, ARGUMENT) ARGUMENT(__global const uint *, from) ARGUMENT(__global uint *, to)\n"
                       "STAGE(copy_queue, COPY_QUEUE) {\n    FOR_EACH_SLOT(i, count) {\n";
    for (unsigned w = 0; w < words; ++w) text += "        to[" + std::to_string(w) + "ul * capacity + i] = from[" + std::to_string(w) + "ul * capacity + i];\n";
    BuildSettings settings;
    settings.constants = {{"LOCAL_SIZE", static_cast<int>(shape.localSize)}, {"ITEMS_PER_WORK_ITEM", static_cast<int>(shape.itemsPerWorkItem)}, {"WIDENS_GROUPS", shape.widensGroups}};
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
