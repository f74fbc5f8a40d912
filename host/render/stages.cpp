#include "render/stages.h"

#include "render/wave_queues.h"

#include <stdexcept>

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

/// The programs that a scene requires, in the order of stagePrograms().
static auto requiredPrograms(const PackedScene& scene) {
    const auto isRequired = [&scene](const StageProgram& program) { return program.isRequired(scene.features, scene.constants); };
    return std::views::filter(stagePrograms(), isRequired);
}

BuildSettings completeSettings(BuildSettings settings, const PackedScene& scene, const StageShape& shape) {
    settings.features = settings.features | scene.features;
    settings.constants["LOCAL_SIZE"] = static_cast<int>(shape.localSize);
    settings.constants["ITEMS_PER_WORK_ITEM"] = static_cast<int>(shape.itemsPerWorkItem);
    settings.constants["WIDENS_GROUPS"] = shape.widensGroups;
    scene.constants.forEach([&](const char* name, int number) { settings.constants[name] = number; });
    return settings;
}

/// Waves of the usual size get queue strides as compile-time constants. Other sizes share kernels with variable strides.
static BuildSettings stageSettings(BuildSettings settings, const PackedScene& scene, const StageShape& shape) {
    settings = completeSettings(std::move(settings), scene, shape);
    const RaySplitting splitting = RaySplitting::of(scene);
    if (splitting.splits || shape.wavePaths != StageShape().wavePaths) return settings;
    const WaveSize size(shape, splitting);
    settings.constants["QUEUE_CAPACITY"] = static_cast<int>(size.capacity);
    settings.constants["PATH_CAPACITY"] = static_cast<int>(size.pathCapacity);
    return settings;
}

/// The settings of one program: its stage's math flags, if they differ.
static BuildSettings settingsOf(const StageProgram& program, BuildSettings settings) {
    for (const StageFlags& s : settings.stageFlags)
        if (s.stage == program.name || s.stage == program.row->name) settings.mathFlags = s.flags;
    return settings;
}

int Stages::missing(const Compiler& compiler, const PackedScene& scene, const StageShape& shape, BuildSettings settings) {
    settings = stageSettings(std::move(settings), scene, shape);
    int count = 0;
    for (const StageProgram& program : requiredPrograms(scene))
        count += !compiler.isKept(program.text, program.row->name, settingsOf(program, settings));
    return count;
}

Stages::Stages(Compiler& compiler, const PackedScene& scene, const StageShape& shape, BuildSettings settings, StagePart part,
               std::function<void()> stepDone)
    : stepDone_(std::move(stepDone)) {
    settings = stageSettings(std::move(settings), scene, shape);
    features_ = settings.features;
    unsigned index = 0;
    for (const StageProgram& program : requiredPrograms(scene)) {
        if (index++ % part.of != part.index) continue;
        Stage stage{program.name, program.row, program.over,
                    Kernel(compiler.build(program.text, program.row->name, settingsOf(program, settings)))};
        stage.compileSeconds = stage.kernel.program().seconds;
        stages_.push_back(std::move(stage));
        this->stepDone(stages_.back());
    }
}

void Stages::stepDone(const Stage& stage) const {
    if (stepDone_ && !stage.kernel.program().fromCache) stepDone_();
}

const Stage& Stages::find(StageName id) const {
    for (const Stage& s : stages_)
        if (s.row->id == id) return s;
    throw std::out_of_range(std::string("the scene does not require ") + rowOf(id).name);
}

void Stages::keep(const Compiler& compiler) const {
    for (const Stage& s : stages_) compiler.keep(s.kernel.program(), s.firstLaunchSeconds);
}

}  // namespace eikonal
