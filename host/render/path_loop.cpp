#include "render/path_loop.h"

#include "kind_features.h"
#include "render/wave_queues.h"

#include <fmt/format.h>

namespace eikonal {

/// The program text: the functions of every BSDF that the scene uses, then the loop.
static std::string loopText(const Features& features) {
    std::string text, list = "#define SCENE_BSDFS(B)";
    const auto include = [&](const char* bsdf) {
        text += fmt::format("#define BSDF {0}\n#include \"bsdf/{0}.clh\"\n#include \"shade/shade_hit.clh\"\n#undef BSDF\n", bsdf);
        list += fmt::format(" B({})", bsdf);
    };
#define INCLUDE_BSDF(bsdf, FEATURE, PARAMETERS) \
    if (features.has(KindFeature::FEATURE)) include(#bsdf);
    BSDFS(INCLUDE_BSDF)
#undef INCLUDE_BSDF
    return text + list + "\n#include \"stages/loop.cl\"\n";
}

PathLoop::PathLoop(const Context& context, Compiler& compiler, const DeviceScene& deviceScene, const PackedScene& scene,
                   const StageShape& shape, const BuildSettings& settings, Profile& profile)
    : context_(context), scene_(deviceScene), splitting_(RaySplitting::of(scene)), shape_(shape),
      mostPaths_(splitting_.pathsIn(shape.wavePaths)), profile_(profile), tables_(context) {
    const BuildSettings complete = completeSettings(settings, scene, shape);
    loop_ = Kernel(compiler.build(loopText(complete.features), "loop", complete));
    resolve_ = Kernel(compiler.build("#include \"stages/resolve_film.cl\"\n", "resolve_film", complete));
    const unsigned capacity = shape.padded(splitting_.statesOf(mostPaths_));
    const auto words = [&](int count) { return static_cast<size_t>(capacity) * static_cast<size_t>(count) * sizeof(cl_uint); };
    hit_ = Buffer(context, words(itemLayout(Queue::hit, complete.features).words), "hits");
    path_ = Buffer(context, words(itemLayout(Queue::path, complete.features, scene.constants).words), "paths");
    bindings_.set("hit", hit_);
    bindings_.set("path", path_);
    for (const char* name : {"capacity", "path_capacity"}) bindings_.set(name, capacity);
    bindings_.set("first_path", 0u);
    bindings_.set("shading_passes", splitting_.shadingPasses);
}

void PathLoop::trace(const BatchStream& stream) {
    while (const std::optional<Batch> batch = stream.next()) {
        tables_.write(context_, *batch, stream.endX, stream.endY);
        const unsigned paths = batch->paths();
        splitting_.clearStates(context_, path_);
        bindings_.set("count", paths);
        profile_.add("loop", paths, loop_.launch(context_, {&scene_.bindings(), &bindings_, &tables_.bindings()}, paths, shape_.group()));
        context_.flush();
        stream.meanwhile();
        context_.finish();
        if (stopFlag().isRaised()) return;
        stream.traced(*batch);
    }
}

void PathLoop::resolve(const Batch& batch, const Buffer& film) {
    Bindings own = bindings_;
    own.set("film", film);
    own.set("count", batch.pixels());
    profile_.add("resolve_film", batch.pixels(),
                 resolve_.launch(context_, {&scene_.bindings(), &tables_.bindings(), &own}, batch.pixels(), shape_.group()));
}

}  // namespace eikonal
