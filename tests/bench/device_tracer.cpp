#include "kind_features.h"
#include "tracers.h"

#include "device/layout.h"
#include "eikonal/scene.h"
#include "eikonal/stages.h"
#include "pack/scene_constants.h"

#include <chrono>
#include <cstring>

namespace eikonal {

DeviceTracer::DeviceTracer(const Context& context, const BenchMesh& mesh, const TracerShape& shape) : context_(context), shape_(shape) {
    features_.require(KindFeature::SHAPE_TRIANGLE);
    const TriangleRange triangles{mesh.positions.data(), mesh.indices.data(), mesh.triangles(), 0};
    const auto start = std::chrono::steady_clock::now();
    root_ = buildBvh(tables_, {&triangles, 1}, {}, {.world = true});
    buildSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    /* The tables that the walk reads; the others are bound, but empty */
    const auto bind = [&](const char* name, Buffer buffer) {
        buffers_.push_back(std::move(buffer));
        scene_.set(name, buffers_.back());
    };
#define BIND_EMPTY(type, name) bind(#name, Buffer(context, 0, #name));
    SCENE_TABLES(BIND_EMPTY)
#undef BIND_EMPTY
    bind("shadow_count", Buffer(context, sizeof(cl_uint), "shadow rays"));
    bind("nodes", Buffer::of<bvh_node>(context, tables_.nodes, "nodes"));
    bind("triangle_lines", Buffer::of<triangle_line>(context, tables_.triangleLines, "triangles"));

    Compiler compiler(context, findKernelFolders(), "");
    BuildSettings settings;
    settings.features = features_;
    settings.constants = {{"LOCAL_SIZE", shape.localSize},
                          {"ITEMS_PER_WORK_ITEM", shape.itemsPerWorkItem},
                          {"WIDENS_GROUPS", context.device().widensGroups}};
    const SceneConstants constants{.interleavedRays = shape.interleavedRays};
    constants.forEach([&](const char* name, int number) { settings.constants[name] = number; });
    intersect_ = Kernel(compiler.build("#include \"stages/intersect_rays.cl\"\n", "intersect_rays", settings));
    occlude_ = Kernel(compiler.build("#include \"stages/test_shadows.cl\"\n", "test_shadows", settings));
}

/// The words of a queue in which items are filled field by field.
class QueueWords {
public:
    QueueWords(const std::string& name, const Features& features, size_t capacity)
        : layout_(queueLayout(name, features)), capacity_(capacity), words(static_cast<size_t>(layout_.words) * capacity) {}
    void set(const char* field, size_t i, float v) { std::memcpy(&words[at(field) * capacity_ + i], &v, sizeof v); }
    void set(const char* field, size_t i, uint v) { words[at(field) * capacity_ + i] = v; }
    void set(const char* field, size_t i, vec3 v) {
        std::memcpy(&words[at(field) * capacity_ + i], &v.x, sizeof v.x);
        std::memcpy(&words[(at(field) + 1) * capacity_ + i], &v.y, sizeof v.y);
        std::memcpy(&words[(at(field) + 2) * capacity_ + i], &v.z, sizeof v.z);
    }
    float get(const char* field, size_t i) const { float v; std::memcpy(&v, &words[at(field) * capacity_ + i], sizeof v); return v; }
    uint getUint(const char* field, size_t i) const { return words[at(field) * capacity_ + i]; }

private:
    size_t at(const char* field) const { return static_cast<size_t>(layout_.field(field).slot); }
    QueueLayout layout_;
    size_t capacity_;

public:
    std::vector<uint> words;
};

void DeviceTracer::uploadRays(const std::vector<BenchRay>& rays, size_t batch, bool shadows) {
    batches_.clear();
    shadows_ = shadows;
    for (size_t first = 0; first < rays.size(); first += batch) {
        const size_t count = std::min(batch, rays.size() - first);
        QueueWords in(shadows ? "shadow" : "ray", features_, batch), out(shadows ? "path" : "intersection", features_, batch);
        for (size_t i = 0; i < count; ++i) {
            in.set("o", i, rays[first + i].o);
            in.set("d", i, rays[first + i].d);
            in.set("t_max", i, rays[first + i].tMax);
            in.set("path", i, static_cast<uint>(i));
            if (shadows) in.set("Ld", i, vec3{1, 1, 1});
        }
        batches_.push_back({count, Buffer::of<uint>(context_, in.words, "rays"), Buffer::of<uint>(context_, out.words, "hits")});
    }
}

void DeviceTracer::trace() {
    for (const Batch& b : batches_) {
        Bindings queues;
        queues.set(shadows_ ? "shadow" : "ray", b.in);
        queues.set(shadows_ ? "path" : "intersection", b.out);
        const auto capacity = static_cast<cl_uint>(b.in.size() / sizeof(uint) /
                                                   static_cast<size_t>(queueLayout(shadows_ ? "shadow" : "ray", features_).words));
        for (const char* name : {"capacity", "path_capacity"}) queues.set(name, capacity);
        queues.set("count", static_cast<cl_uint>(b.count));
        (shadows_ ? occlude_ : intersect_)
            .launch(context_, {&scene_, &queues}, b.count,
                    static_cast<size_t>(shape_.localSize) * static_cast<size_t>(shape_.itemsPerWorkItem));
    }
    context_.finish();
}

std::vector<BenchHit> DeviceTracer::download() const {
    std::vector<BenchHit> hits;
    for (const Batch& b : batches_) {
        const std::string name = shadows_ ? "path" : "intersection";
        QueueWords out(name, features_, b.out.size() / sizeof(uint) / static_cast<size_t>(queueLayout(name, features_).words));
        b.out.read(context_, out.words.data(), out.words.size() * sizeof(uint));
        for (size_t i = 0; i < b.count; ++i) {
            if (shadows_) { hits.push_back({out.get("L", i) > 0 ? -1.f : 0.f, NONE}); continue; }
            const uint element = out.getUint("element", i);
            hits.push_back({element == NONE ? -1 : out.get("t", i), element});
        }
    }
    return hits;
}

}  // namespace eikonal
