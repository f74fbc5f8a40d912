#include "render/displacement.h"

#include "pack/pack.h"
#include "pack/space.h"
#include "parallel_errors.h"
#include "render/device_scene.h"
#include "read/mesh/displacement.h"
#include "read/formats/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace eikonal {
namespace {

/// Vertices per kernel launch.
constexpr size_t verticesAtATime = size_t(1) << 20;

template <class F> void forEachShape(Scene& scene, const F& f) {
    for (Shape& s : scene.shapes) f(s);
    for (Object& o : scene.objects)
        for (Shape& s : o.shapes) f(s);
}

/// A mesh while it is displaced.
struct DisplacedMesh {
    Shape* shape;
    Mesh mesh;
    std::vector<float> heights;
};

bool isFinite(const glm::vec3& v) { return std::isfinite(v.x + v.y + v.z); }

Mesh splitMesh(const Shape& s) {
    const Mesh& whole = *s.mesh;
    const Displacement& d = *s.displacement;
    for (const std::uint32_t corner : whole.indices)
        if (!whole.normals.empty() && !isFinite(whole.normals[corner]))
            throw SceneError(d.where, "a mesh is displaced along its normals, but this mesh has a normal that is not finite");
    Mesh mesh = whole;
    const Split split = splitLongEdges(mesh, fromPositions(s.worldFromObject, mesh.origin), d.edgeLength);
    if (split == Split::tooFine)
        throw SceneError(d.where, fmt::format("edges of this mesh cannot be split until all are shorter than {:g}: single precision cannot "
                                              "resolve them this far from the origin",
                                              d.edgeLength));
    if (split == Split::tooMany) {
        const double possible = shortestEdgeLength(whole, fromPositions(s.worldFromObject, whole.origin));
        throw SceneError(d.where,
                         fmt::format("edges shorter than {:g} need more than {} triangles in this mesh, the maximum{}", d.edgeLength,
                                     mostDisplacedTriangles,
                                     possible > d.edgeLength ? fmt::format("; \"float edgelength\" {:.2g} would work", possible) : ""));
    }
    return mesh;
}

class HeightLookup {
public:
    HeightLookup(const PackedScene& textures, const Context& context, Compiler& compiler, const StageShape& shape,
                 const BuildSettings& settings)
        : context_(context),
          compiler_(compiler),
          shape_(shape),
          scene_(context, textures),
          kernel_(compiler.build("#include \"stages/displace_vertices.cl\"\n", "displace_vertices",
                                 completeSettings(settings, textures, shape))) {}
    /// Stores the kernel in the cache. Call it after the first run.
    void keep() const { compiler_.keep(kernel_.program()); }

    /// Evaluates the heights with texture program `program`.
    void run(DisplacedMesh& displaced, uint program) {
        displaced.heights.resize(displaced.mesh.positions.size());
        for (size_t first = 0; first < displaced.heights.size(); first += verticesAtATime)
            run(displaced, program, first, std::min(verticesAtATime, displaced.heights.size() - first));
    }

private:
    void run(DisplacedMesh& displaced, uint program, size_t first, size_t count) {
        const Mesh& mesh = displaced.mesh;
        const Transform m = fromPositions(displaced.shape->worldFromObject, mesh.origin);
        std::vector<vec3> points, normals;
        std::vector<vec2> uvs;
        for (size_t i = first; i < first + count; ++i) {
            points.push_back(toVec3(transformPoint(m, mesh.positions[i])));
            normals.push_back(toVec3(transformNormal(m, mesh.normals[i])));
            uvs.push_back(mesh.uvs.empty() ? vec2{0, 0} : vec2{mesh.uvs[i].x, mesh.uvs[i].y});
        }
        const Buffer pointBuffer = Buffer::of<vec3>(context_, points, "points of meshes"),
                     normalBuffer = Buffer::of<vec3>(context_, normals, "normals of meshes"),
                     uvBuffer = Buffer::of<vec2>(context_, uvs, "texture coordinates of meshes"),
                     heights(context_, count * sizeof(float), "heights of meshes");
        Bindings bindings;
        bindings.set("vertex_points", pointBuffer);
        bindings.set("vertex_normals", normalBuffer);
        bindings.set("vertex_uvs", uvBuffer);
        bindings.set("heights", heights);
        bindings.set("program", program);
        bindings.set("count", static_cast<uint>(count));
        for (const char* name : {"capacity", "path_capacity"}) bindings.set(name, 0u);
        const Owned<cl_event, clReleaseEvent> launched(kernel_.launch(context_, {&scene_.bindings(), &bindings}, count, shape_.group()));
        heights.read(context_, displaced.heights.data() + first, count * sizeof(float));
    }

    const Context& context_;
    Compiler& compiler_;
    StageShape shape_;
    DeviceScene scene_;
    Kernel kernel_;
};

void finish(DisplacedMesh& displaced) {
    Shape& s = *displaced.shape;
    displaceVertices(displaced.mesh, displaced.heights);
    for (const std::uint32_t corner : displaced.mesh.indices)
        if (!isFinite(displaced.mesh.positions[corner]))
            throw SceneError(s.displacement->where, "this texture moves a vertex to a position that is not finite");
    s.mesh = std::make_shared<Mesh>(std::move(displaced.mesh));
    s.displacement.reset();
}

}  // namespace

bool hasDisplacedMeshes(const Scene& scene) {
    const auto isDisplaced = [](const Shape& s) { return s.displacement.has_value(); };
    return std::ranges::any_of(scene.shapes, isDisplaced) ||
           std::ranges::any_of(scene.objects, [&](const Object& o) { return std::ranges::any_of(o.shapes, isDisplaced); });
}

void displaceMeshes(Scene& scene, const Context& context, Compiler& compiler, const StageShape& shape, const BuildSettings& settings,
                    Diagnostics& diagnostics) {
    std::vector<DisplacedMesh> meshes;
    std::vector<int> textures;
    forEachShape(scene, [&](Shape& s) {
        if (!s.displacement) return;
        meshes.push_back({&s, {}, {}});
        textures.push_back(s.displacement->texture);
        if (s.mesh->uvs.empty())
            diagnostics.warn(s.displacement->where,
                             "this mesh has no texture coordinates; its displacement texture is looked up at (0, 0)");
    });

    const auto images = loadImages(scene.images);
    for (size_t i = 0; i < images.size(); ++i) scene.images[i].pixels = images[i];
    const PackedTextures packed = packTextures(scene, textures, diagnostics);
    forEachInParallel(meshes.size(), [&](size_t i) { meshes[i].mesh = splitMesh(*meshes[i].shape); });
    HeightLookup lookup(packed.scene, context, compiler, shape, settings);
    for (size_t i = 0; i < meshes.size(); ++i) lookup.run(meshes[i], packed.programs[i]);
    lookup.keep();
    forEachInParallel(meshes.size(), [&](size_t i) { finish(meshes[i]); });
}

}  // namespace eikonal
