#include "render/stages.h"

#include "render/wave_queues.h"

#include <fmt/format.h>

namespace eikonal {

StageShape StageShape::forDevice(const DeviceInfo& device) {
    StageShape shape;
    shape.widensGroups = device.widensGroups;
    if (!device.isCpu) {
        shape.localSize = 64;
        shape.itemsPerWorkItem = 1;
        shape.wavePaths = 1u << 20;
        shape.batches = 2;
    }
    shape.localSize = static_cast<unsigned>(std::min<size_t>(shape.localSize, device.largestGroup));
    return shape;
}

struct StageRequest { std::string name, kernel, text; uint next_queue; };

/// What a scene requires, in the order in which it runs.
static std::vector<StageRequest> requiredStages(const PackedScene& scene) {
    std::vector<StageRequest> list;
    const auto add = [&](const std::string& name, bool required) {
        if (!required) return;
        if (name != "shade_hits") { list.push_back({name, name, fmt::format("#include \"stages/{}.cl\"\n", name), next_none}); return; }
        const auto shading = [&](const std::string& bsdf, Feature feature, uint next_queue) {
            if (scene.features.has(feature))
                list.push_back({"shade_hits " + bsdf, name, fmt::format("#define BSDF {0}\n#include \"bsdf/{0}.clh\"\n#include \"stages/{1}.cl\"\n", bsdf, name), next_queue});
        };
#define SHADE_BSDF(bsdf, FEATURE, PARAMETERS) shading(#bsdf, Feature::FEATURE, next_##bsdf);
        BSDFS(SHADE_BSDF)
#undef SHADE_BSDF
    };
    constexpr Feature ALWAYS = Feature::count;
    const auto required = [&](Feature f) { return f == ALWAYS || scene.features.has(f); };
    using enum Feature;
#define ADD_STAGE(name, reads, writes, FEATURE) add(#name, required(FEATURE) && (std::string(#name) != "shade_misses" || scene.constants.environments > 0));
    STAGES(ADD_STAGE)
#undef ADD_STAGE
    for (const char* name : {"survey_vertices", "survey_environment"}) add(name, scene.features.has(Feature::ENVIRONMENT_GUIDE));
    return list;
}

BuildSettings completeSettings(BuildSettings settings, const PackedScene& scene, const StageShape& shape) {
    settings.features = settings.features | scene.features;
    settings.constants["LOCAL_SIZE"] = static_cast<int>(shape.localSize);
    settings.constants["ITEMS_PER_WORK_ITEM"] = static_cast<int>(shape.itemsPerWorkItem);
    settings.constants["WIDENS_GROUPS"] = shape.widensGroups;
    scene.constants.forEach([&](const char* name, int number) { settings.constants[name] = number; });
    return settings;
}

/// Strides of queues are constants where waves have their usual size; others are not worth kernels of their own.
static BuildSettings stageSettings(BuildSettings settings, const PackedScene& scene, const StageShape& shape) {
    settings = completeSettings(std::move(settings), scene, shape);
    const RaySplitting splitting = RaySplitting::of(scene);
    if (splitting.splits || shape.wavePaths != StageShape().wavePaths) return settings;
    const WaveSize size(shape, splitting);
    settings.constants["QUEUE_CAPACITY"] = static_cast<int>(size.capacity);
    settings.constants["PATH_CAPACITY"] = static_cast<int>(size.pathCapacity);
    return settings;
}

int Stages::missing(const Compiler& compiler, const PackedScene& scene, const StageShape& shape, BuildSettings settings) {
    settings = stageSettings(std::move(settings), scene, shape);
    int count = 0;
    for (const StageRequest& request : requiredStages(scene)) count += !compiler.isKept(request.text, request.kernel, settings);
    return count;
}

Stages::Stages(Compiler& compiler, const PackedScene& scene, const StageShape& shape, BuildSettings settings, StagePart part) {
    shading_.fill(-1);
    settings = stageSettings(std::move(settings), scene, shape);
    unsigned index = 0;
    for (const StageRequest& request : requiredStages(scene)) {
        if (index++ % part.of != part.index) continue;
        Stage stage;
        stage.name = request.name;
        stage.kernel = Kernel(compiler.build(request.text, request.kernel, settings));
        stage.compileSeconds = stage.kernel.program().seconds;
        if (request.next_queue < next_queues) shading_[request.next_queue] = static_cast<int>(stages_.size());
        stages_.push_back(std::move(stage));
    }
}

const Stage* Stages::find(const std::string& name) const {
    for (const Stage& s : stages_)
        if (s.name == name) return &s;
    return nullptr;
}

void Stages::keep(const Compiler& compiler) const {
    for (const Stage& s : stages_) compiler.keep(s.kernel.program(), s.firstLaunchSeconds);
}

}  // namespace eikonal
