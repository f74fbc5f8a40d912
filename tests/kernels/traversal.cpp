#include "traversal.h"

#include "pack/pack.h"
#include "stage.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

namespace eikonal {

std::vector<Hit> trace(const PackedScene& scene, const std::vector<Ray>& rays) {
    StageBench bench(scene, static_cast<unsigned>(rays.size()));
    QueueWords queue = bench.empty("ray");
    for (size_t i = 0; i < rays.size(); ++i) {
        queue.set("o", i, rays[i].o);
        queue.set("d", i, rays[i].d);
        queue.set("t_max", i, rays[i].tMax);
    }
    bench.write("ray", queue);
    bench.run("intersect_rays", static_cast<unsigned>(rays.size()));
    const QueueWords intersections = bench.read("intersection");
    std::vector<Hit> hits;
    for (size_t i = 0; i < rays.size(); ++i)
        hits.push_back({intersections.get<float>("t", i), intersections.get<uint>("element", i),
                        scene.features.has(Feature::INSTANCES) ? intersections.get<uint>("instance", i) : NONE,
                        intersections.get<float>("u", i), intersections.get<float>("v", i)});
    return hits;
}

std::vector<bool> blocked(const PackedScene& scene, const std::vector<Ray>& rays) {
    StageBench bench(scene, static_cast<unsigned>(rays.size()));
    QueueWords queue = bench.empty("shadow");
    for (size_t i = 0; i < rays.size(); ++i) {
        queue.set("path", i, static_cast<uint>(i));
        queue.set("o", i, rays[i].o);
        queue.set("d", i, rays[i].d);
        queue.set("t_max", i, rays[i].tMax);
        queue.set("Ld", i, spectrum{1, 2, 3});
    }
    bench.write("shadow", queue);
    bench.resetCounters();
    bench.run("test_shadows", static_cast<unsigned>(rays.size()));
    EXPECT_EQ(bench.shadowRays(), rays.size());
    const QueueWords paths = bench.read("path");
    std::vector<bool> result;
    for (size_t i = 0; i < rays.size(); ++i) result.push_back(paths.get<spectrum>("L", i).b == 0);
    return result;
}

PackedScene pack(const Scene& scene) {
    Diagnostics diagnostics(LogLevel::silent);
    return packScene(scene, diagnostics);
}

glm::dmat4 randomTransform(Random& random, double size) {
    const auto axis = [&] { return glm::dvec3(toGlm(random.direction())); };
    const glm::dvec3 z = axis(), x = glm::normalize(glm::cross(z, axis())), y = glm::cross(z, x);
    glm::dmat4 m(glm::dmat3(x * (size * random.between(0.5f, 1.5f)), y * (size * random.between(0.5f, 1.5f)),
                            z * (size * random.between(0.5f, 1.5f))));
    m[3] = glm::dvec4(glm::dvec3(toGlm(random.box(1))), 1);
    return m;
}

Shape placed(Shape s, const glm::dmat4& m) {
    s.worldFromObject = m;
    return s;
}

static Shape newShape(shape_kind kind) {
    Shape s;
    s.kind = &kindOf(kind);
    return s;
}

static void addCorner(Mesh& mesh, glm::vec3 p) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.push_back(p);
}

Shape randomTriangles(Random& random, size_t count) {
    auto mesh = std::make_shared<Mesh>();
    for (size_t i = 0; i < count; ++i) {
        const glm::vec3 p = toGlm(random.box(1));
        const float size = random.logBetween(0.02f, 1);
        for (int k = 0; k < 3; ++k) addCorner(*mesh, p + toGlm(random.box(size)));
    }
    return triangleMesh(mesh);
}

static Shape randomPatches(Random& random, size_t count) {
    auto mesh = std::make_shared<Mesh>();
    for (size_t i = 0; i < count; ++i) {
        const glm::vec3 p = toGlm(random.box(1)), u = toGlm(random.box(0.5f)), v = toGlm(random.box(0.5f));
        const glm::vec3 twist = random.below(3) ? toGlm(random.box(0.3f)) : glm::vec3(0);
        for (const glm::vec3& q : {p, p + u, p + v, p + u + v + twist}) addCorner(*mesh, q);
    }
    return bilinearMesh(mesh);
}

static Shape randomSphere(Random& random) {
    Shape s = newShape(shape_sphere);
    if (random.below(2)) { s.zMin = random.between(-1, 0); s.zMax = random.between(0.1f, 1); }
    if (random.below(2)) s.phiMax = random.between(30, 330);
    return placed(s, randomTransform(random, 0.3));
}

static Shape randomDisk(Random& random) {
    Shape d = newShape(shape_disk);
    if (random.below(2)) d.innerRadius = random.between(0.2f, 0.8f);
    if (random.below(2)) d.phiMax = random.between(30, 330);
    d.height = random.between(-0.5f, 0.5f);
    return placed(d, randomTransform(random, 0.4));
}

static Shape randomCylinder(Random& random) {
    Shape c = newShape(shape_cylinder);
    if (random.below(2)) { c.zMin = random.between(-2, 0); c.zMax = random.between(0.1f, 2); }
    if (random.below(2)) c.phiMax = random.between(30, 330);
    return placed(c, randomTransform(random, 0.2));
}

/// Two segments, of any type, wider at one end; of every second the transform keeps angles.
static Shape randomCurve(Random& random) {
    auto curve = std::make_shared<Curve>();
    curve->type = std::array{curve_flat, curve_cylinder, curve_ribbon}[random.below(3)];
    curve->splitDepth = static_cast<int>(random.below(5));
    glm::vec3 p = toGlm(random.box(1)), step = 0.3f * toGlm(random.direction()), n = toGlm(random.direction());
    double width = random.logBetween(0.01f, 0.2f);
    for (int i = 0; i < 2; ++i) {
        CurveSegment s;
        for (glm::vec3& q : s.points) { q = p; p += step + toGlm(random.box(0.15f)); }
        p = s.points[3];
        s.normals[0] = n;
        s.normals[1] = n = n + toGlm(random.box(0.4f));
        s.width[0] = width;
        s.width[1] = width *= random.between(0.5f, 1);
        curve->segments.push_back(s);
    }
    glm::dmat4 m = randomTransform(random, 0.4);
    if (random.below(2))
        for (int i = 0; i < 3; ++i) m[i] = 0.5 * glm::normalize(m[i]);
    Shape s = newShape(shape_curve);
    s.curve = curve;
    return placed(s, m);
}

std::shared_ptr<Mesh> closedMesh(int steps, bool round) {
    auto mesh = std::make_shared<Mesh>();
    std::map<std::array<int, 3>, std::uint32_t> known;
    const auto vertex = [&](int x, int y, int z) {
        const auto [at, isNew] = known.try_emplace({x, y, z}, static_cast<std::uint32_t>(mesh->positions.size()));
        const glm::vec3 p(static_cast<float>(x) / static_cast<float>(steps), static_cast<float>(y) / static_cast<float>(steps),
                          static_cast<float>(z) / static_cast<float>(steps));
        if (isNew) mesh->positions.push_back(round ? glm::normalize(p) : p);
        return at->second;
    };
    for (int octant = 0; octant < 8; ++octant) {
        const int sx = octant & 1 ? -1 : 1, sy = octant & 2 ? -1 : 1, sz = octant & 4 ? -1 : 1;
        const auto at = [&](int i, int j) { return vertex(sx * i, sy * j, sz * (steps - i - j)); };
        for (int i = 0; i < steps; ++i)
            for (int j = 0; i + j < steps; ++j) {
                for (std::uint32_t v : {at(i, j), at(i + 1, j), at(i, j + 1)}) mesh->indices.push_back(v);
                if (i + j + 1 < steps) for (std::uint32_t v : {at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}) mesh->indices.push_back(v);
            }
    }
    return mesh;
}

Scene triangleScene() {
    Random random(60);
    Scene scene;
    scene.shapes.push_back(randomTriangles(random, 600));
    return scene;
}

Scene mixedScene() {
    Random random(61);
    Scene scene;
    scene.shapes.push_back(randomTriangles(random, 60));
    scene.shapes.push_back(randomPatches(random, 60));
    for (int i = 0; i < 40; ++i)
        for (const auto make : {randomSphere, randomDisk, randomCylinder}) scene.shapes.push_back(make(random));
    return scene;
}

Scene curveScene() {
    Random random(77);
    Scene scene;
    for (int i = 0; i < 60; ++i) scene.shapes.push_back(randomCurve(random));
    return scene;
}

Scene instancedScene() {
    Random random(62);
    Scene scene;
    scene.shapes.push_back(randomTriangles(random, 20));
    scene.objects.resize(2);
    scene.objects[0].shapes = {randomTriangles(random, 30)};
    scene.objects[1].shapes = {randomTriangles(random, 10), randomPatches(random, 5), randomSphere(random),
                               randomDisk(random),          randomCylinder(random),   randomCurve(random)};
    for (int i = 0; i < 24; ++i) scene.instances.push_back({i % 2, randomTransform(random, 0.3), {}});
    return scene;
}

std::vector<Ray> randomRays(size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Ray> rays;
    for (size_t i = 0; i < count; ++i) {
        Ray r{random.box(0.5f), random.direction()};
        if (i % 8 == 0) {
            float* d[] = {&r.d.x, &r.d.y, &r.d.z};
            *d[random.below(3)] = random.below(2) ? 0.0f : -0.0f;
            if (random.below(2)) *d[random.below(3)] = 0;
            const float length = static_cast<float>(std::sqrt(dot(r.d, r.d)));
            if (length == 0) r.d = {0, 0, -1};
            else r.d = {r.d.x / length, r.d.y / length, r.d.z / length};
        }
        rays.push_back(r);
    }
    return rays;
}

}  // namespace eikonal
