#include "stage.h"

#include "pack/color_mode.h"
#include "pack/pack.h"
#include "read/pbrt/read_pbrt.h"

#include <stdexcept>

namespace eikonal {

PackedScene packText(const std::string& text, ColorMode color) {
    Diagnostics diagnostics(LogLevel::silent, true);
    Scene scene = readPbrtText(text, "test.pbrt", ".", diagnostics);
    scene.colorMode = color == ColorMode::automatic && needOfWavelengths(scene).empty() ? ColorMode::rgb : color;
    PackedScene packed = packScene(scene, diagnostics);
    if (!diagnostics.warnings().empty()) throw std::invalid_argument("a test's scene gives a warning: " + diagnostics.warnings().front());
    return packed;
}

std::vector<std::string> allStages() {
    std::vector<std::string> stages;
    for (const StageProgram& program : stagePrograms())
        if (program.over != no_queue) stages.push_back(program.name);
    return stages;
}

static WaveSize sizeFor(unsigned paths) {
    return {{.localSize = testLocalSize, .itemsPerWorkItem = testRun, .wavePaths = paths, .batches = 1}, RaySplitting()};
}

StageBench::StageBench(const PackedScene& scene, unsigned paths, bool poisonItems, unsigned filmPixels)
    : scene_(scene), size_(sizeFor(paths)), poisonItems_(poisonItems), onDevice_(testContext(), scene) {
    for (const QueueRow& queue : queueTable)
        layouts_[queue.name] = {itemLayout(queue.id, scene.features, scene.constants), size_.items(queue.placement)};
    layouts_["next_ray"] = layouts_["ray"];
    layouts_["film"] = {filmLayout(scene.features, scene.frame().bucket_count, scene.constants.lightGroups),
                        filmPixels ? filmPixels : paths};
    for (const auto& [name, layout] : layouts_) {
        buffers_[name] = Buffer(testContext(), static_cast<size_t>(layout.first.words) * layout.second * sizeof(uint), "queue " + name);
        bindings_.set(name, buffers_[name]);
        clear(name, name == "path" || name == "film" ? 0 : poison);
    }
    for (const char* name : {"counts", "cursors", "shadow_count"}) {
        buffers_[name] = Buffer(testContext(), wave_counts * sizeof(uint), name);
        bindings_.set(name, buffers_[name]);
    }
    bindings_.set("capacity", size_.capacity);
    bindings_.set("path_capacity", size_.pathCapacity);
    for (const char* name : {"shading_pass", "pass_slots", "begun", "first_path"}) bindings_.set(name, 0u);
    bindings_.set("log2_batch_paths", 31u);
}

QueueWords StageBench::empty(const std::string& queue) const { return {layouts_.at(queue).first, layouts_.at(queue).second, poison}; }

void StageBench::clear(const std::string& queue, uint word) {
    QueueWords words = empty(queue);
    std::fill(words.words().begin(), words.words().end(), word);
    write(queue, words);
}

QueueWords StageBench::read(const std::string& queue) const {
    QueueWords words = empty(queue);
    buffers_.at(queue).read(testContext(), words.words().data(), words.words().size() * sizeof(uint));
    return words;
}

void StageBench::write(const std::string& queue, const QueueWords& words) {
    buffers_.at(queue).write(testContext(), words.words().data(), words.words().size() * sizeof(uint));
}

std::vector<uint> StageBench::readWords(const std::string& buffer, size_t count) const {
    std::vector<uint> words(count);
    buffers_.at(buffer).read(testContext(), words.data(), words.size() * sizeof(uint));
    return words;
}

void StageBench::resetCounters() {
    for (const char* name : {"counts", "cursors", "shadow_count"}) buffers_[name].clear(testContext(), 0, wave_counts * sizeof(uint));
}

StageBench::State StageBench::save() const {
    State state;
    for (const auto& [name, buffer] : buffers_) state[name] = readWords(name, buffer.size() / sizeof(uint));
    return state;
}

void StageBench::restore(const State& state) {
    for (const auto& [name, words] : state) buffers_.at(name).write(testContext(), words.data(), words.size() * sizeof(uint));
}

void StageBench::run(const std::string& stage, unsigned count, unsigned first) {
    const std::pair known(stage, mathFlags_);
    if (!kernels_.count(known)) {
        BuildSettings settings = shippedSettings(scene_.features, scene_.constants);
        settings.poison = poisonItems_;
        settings.mathFlags = mathFlags_;
        const StageProgram& program = stageProgram(stage);
        kernels_[known] = Kernel(testCompiler().build(program.text, program.row->name, settings));
    }
    Bindings arguments = bindings_;
    arguments.set("first", first);
    arguments.set("count", count);
    const unsigned group = StageShape{.localSize = testLocalSize, .itemsPerWorkItem = testRun}.group(stageProgram(stage).row->form);
    kernels_[known].launch(testContext(), {&onDevice_.bindings(), &tables_.bindings(), &arguments}, count, group);
    testContext().finish();
    testCompiler().keep(kernels_[known].program());
}

void StageBench::runOver(uint items, SlotRange slots) {
    for (const StageProgram& program : stagePrograms())
        if (program.over == items && program.isRequired(scene_.features, scene_.constants)) run(program.name, slots.count, slots.first);
}

}  // namespace eikonal
