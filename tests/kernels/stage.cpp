#include "stage.h"

#include "pack/pack.h"
#include "read/pbrt/read_pbrt.h"

#include <fmt/format.h>

#include <stdexcept>

namespace eikonal {

PackedScene packText(const std::string& text, ColorMode color) {
    Diagnostics diagnostics(LogLevel::silent, true);
    Scene scene = readPbrtText(text, "test.pbrt", ".", diagnostics);
    scene.colorMode = color;
    PackedScene packed = packScene(scene, diagnostics);
    if (!diagnostics.warnings().empty()) throw std::invalid_argument("the scene of a test gives a warning: " + diagnostics.warnings().front());
    return packed;
}

StageText stageText(const std::string& stage) {
    const size_t space = stage.find(' ');
    if (space == std::string::npos) return {stage, fmt::format("#include \"stages/{}.cl\"\n", stage)};
    const std::string kernel = stage.substr(0, space), bsdf = stage.substr(space + 1);
    return {kernel, fmt::format("#define BSDF {0}\n#include \"bsdf/{0}.clh\"\n#include \"stages/{1}.cl\"\n", bsdf, kernel)};
}

std::vector<std::string> allStages() {
    std::vector<std::string> stages;
    const auto add = [&](const std::string& name) {
        if (!hasKernelFile("stages/" + name + ".cl")) return;
        if (name != "shade_hits") { stages.push_back(name); return; }
#define ADD_BSDF(bsdf, FEATURE, PARAMETERS) if (hasKernelFile("bsdf/" #bsdf ".clh")) stages.push_back("shade_hits " #bsdf);
        BSDFS(ADD_BSDF)
#undef ADD_BSDF
    };
#define ADD_STAGE(name, reads, writes, FEATURE) add(#name);
    STAGES(ADD_STAGE)
#undef ADD_STAGE
    return stages;
}

StageBench::StageBench(const PackedScene& scene, unsigned paths, bool poisonItems, unsigned filmPixels)
    : scene_(scene), capacity_((paths + testGroup - 1) / testGroup * testGroup + (next_queues + 1) * testGroup), poisonItems_(poisonItems), onDevice_(testContext(), scene) {
    for (QueueLayout layout : queueLayouts(scene.features)) {
        if (layout.name == "hit") layout.words += bsdfWords(scene.features);
        layouts_[layout.name] = {layout, capacity_};
        if (layout.name == "ray") layouts_["next_ray"] = {layout, capacity_};
    }
    layouts_["film"] = {filmLayout(scene.features, scene.frame().bucket_count), filmPixels ? filmPixels : paths};
    for (const auto& [name, layout] : layouts_) {
        buffers_[name] = Buffer(testContext(), static_cast<size_t>(layout.first.words) * layout.second * sizeof(uint), "queue " + name);
        bindings_.set(name, buffers_[name]);
        clear(name, name == "path" || name == "film" ? 0 : poison);
    }
    for (const char* name : {"counts", "cursors", "shadow_count"}) {
        buffers_[name] = Buffer(testContext(), wave_counts * sizeof(uint), name);
        bindings_.set(name, buffers_[name]);
    }
    for (const char* name : {"capacity", "path_capacity"}) bindings_.set(name, capacity_);
    for (const char* name : {"shading_pass", "pass_slots", "begun", "first_path"}) bindings_.set(name, 0u);
    bindings_.set("log2_batch_paths", 31u);
}

QueueWords StageBench::empty(const std::string& queue) const { return {layouts_.at(queue).first, layouts_.at(queue).second, poison}; }

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

void StageBench::run(const std::string& stage, unsigned count, unsigned first) {
    if (!kernels_.count(stage)) {
        BuildSettings settings = shippedSettings(scene_.features, scene_.constants);
        settings.poison = poisonItems_;
        const auto [kernel, text] = stageText(stage);
        kernels_[stage] = Kernel(testCompiler().build(text, kernel, settings));
    }
    Bindings arguments = bindings_;
    arguments.set("first", first);
    arguments.set("count", count);
    kernels_[stage].launch(testContext(), {&onDevice_.bindings(), &tables_.bindings(), &arguments}, count, testGroup);
    testContext().finish();
    testCompiler().keep(kernels_[stage].program());
}

}  // namespace eikonal
