// Tracing against brute force in double precision: nearest hits (intersect_rays) and blockers (test_shadows).

#include "brute_force.h"
#include "pack/pack.h"
#include "random_inputs.h"
#include "stage.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

namespace eikonal {
namespace {

struct Ray { vec3 o, d; float tMax = FAR_AWAY; };
struct Hit { float t; uint element, instance; float u, v; };

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
    const QueueWords flights = bench.read("flight");
    std::vector<Hit> hits;
    for (size_t i = 0; i < rays.size(); ++i)
        hits.push_back({flights.get<float>("t", i), flights.get<uint>("element", i), scene.features.has(Feature::INSTANCES) ? flights.get<uint>("instance", i) : NONE,
                        flights.get<float>("u", i), flights.get<float>("v", i)});
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
    EXPECT_EQ(bench.tally()[tally_shadow_rays], rays.size());
    const QueueWords paths = bench.read("path");
    std::vector<bool> result;
    for (size_t i = 0; i < rays.size(); ++i) result.push_back(paths.get<spectrum>("L", i).b == 0);
    return result;
}

// ---- scenes ------------------------------------------------------------------------------------------------------------

PackedScene pack(const Scene& scene) {
    Diagnostics diagnostics(LogLevel::silent);
    return packScene(scene, diagnostics);
}

glm::vec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }

glm::dmat4 randomTransform(Random& random, double size) {
    const auto axis = [&] { return glm::dvec3(toGlm(random.direction())); };
    const glm::dvec3 z = axis(), x = glm::normalize(glm::cross(z, axis())), y = glm::cross(z, x);
    glm::dmat4 m(glm::dmat3(x * (size * random.between(0.5f, 1.5f)), y * (size * random.between(0.5f, 1.5f)), z * (size * random.between(0.5f, 1.5f))));
    m[3] = glm::dvec4(glm::dvec3(toGlm(random.box(1))), 1);
    return m;
}

Shape shapeOf(decltype(Shape::kind) kind, const glm::dmat4& m = glm::dmat4(1)) {
    Shape s;
    s.kind = std::move(kind);
    s.worldFromObject = m;
    return s;
}

Shape randomTriangles(Random& random, size_t count) {
    auto mesh = std::make_shared<Mesh>();
    for (size_t i = 0; i < count; ++i) {
        const glm::vec3 p = toGlm(random.box(1));
        const float size = random.logBetween(0.02f, 1);
        for (int k = 0; k < 3; ++k) {
            mesh->indices.push_back(static_cast<std::uint32_t>(mesh->positions.size()));
            mesh->positions.push_back(p + toGlm(random.box(size)));
        }
    }
    return shapeOf(TriangleMesh{mesh});
}

Shape randomPatches(Random& random, size_t count) {
    auto mesh = std::make_shared<Mesh>();
    for (size_t i = 0; i < count; ++i) {
        const glm::vec3 p = toGlm(random.box(1)), u = toGlm(random.box(0.5f)), v = toGlm(random.box(0.5f));
        const glm::vec3 twist = random.below(3) ? toGlm(random.box(0.3f)) : glm::vec3(0);
        for (const glm::vec3& q : {p, p + u, p + v, p + u + v + twist}) {
            mesh->indices.push_back(static_cast<std::uint32_t>(mesh->positions.size()));
            mesh->positions.push_back(q);
        }
    }
    return shapeOf(BilinearMesh{mesh});
}

Shape randomSphere(Random& random) {
    Sphere s;
    if (random.below(2)) { s.zMin = random.between(-1, 0); s.zMax = random.between(0.1f, 1); }
    if (random.below(2)) s.phiMax = random.between(30, 330);
    return shapeOf(s, randomTransform(random, 0.3));
}

Shape randomDisk(Random& random) {
    Disk d;
    if (random.below(2)) d.innerRadius = random.between(0.2f, 0.8f);
    if (random.below(2)) d.phiMax = random.between(30, 330);
    d.height = random.between(-0.5f, 0.5f);
    return shapeOf(d, randomTransform(random, 0.4));
}

Shape randomCylinder(Random& random) {
    Cylinder c;
    if (random.below(2)) { c.zMin = random.between(-2, 0); c.zMax = random.between(0.1f, 2); }
    if (random.below(2)) c.phiMax = random.between(30, 330);
    return shapeOf(c, randomTransform(random, 0.2));
}

/// Two segments, of any type, wider at one end; of every second the transform keeps angles.
Shape randomCurve(Random& random) {
    auto curve = std::make_shared<Curve>();
    curve->kind = std::array{CurveKind::flat, CurveKind::cylinder, CurveKind::ribbon}[random.below(3)];
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
    return shapeOf(CurveShape{curve}, m);
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

/// Two objects, of triangles and of everything, many times, turned and stretched; and some shapes of the world.
Scene instancedScene() {
    Random random(62);
    Scene scene;
    scene.shapes.push_back(randomTriangles(random, 20));
    scene.objects.resize(2);
    scene.objects[0].shapes = {randomTriangles(random, 30)};
    scene.objects[1].shapes = {randomTriangles(random, 10), randomPatches(random, 5), randomSphere(random), randomDisk(random), randomCylinder(random), randomCurve(random)};
    for (int i = 0; i < 24; ++i) scene.instances.push_back({i % 2, randomTransform(random, 0.3), {}});
    return scene;
}

/// Random rays; one in eight parallel to an axis or a plane of axes, also with a negative zero.
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

struct SceneCase { std::string name; Scene (*make)(); size_t rays; };
void PrintTo(const SceneCase& c, std::ostream* out) { *out << c.name; }

class Traversal : public testing::TestWithParam<SceneCase> {};

TEST_P(Traversal, FindsTheNearestHit) {
    const PackedScene scene = pack(GetParam().make());
    const BruteForce truth(scene);
    const auto rays = randomRays(GetParam().rays, 63);
    const auto hits = trace(scene, rays);
    size_t met = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(judgeHit(truth.meet(rays[i].o, rays[i].d), hits[i].element, hits[i].instance, hits[i].t), "") << "ray " << i;
        met += hits[i].element != NONE;
    }
    EXPECT_GT(met, rays.size() / 100);
    EXPECT_LT(met, rays.size());
}

/// Shadow rays stop at the first blocker, whichever, within their length: some short, some long.
TEST_P(Traversal, FindsBlockers) {
    const PackedScene scene = pack(GetParam().make());
    const BruteForce truth(scene);
    auto rays = randomRays(GetParam().rays, 64);
    Random random(65);
    for (Ray& r : rays) r.tMax = random.below(4) ? random.between(0.02f, 0.5f) : FAR_AWAY;
    const auto results = blocked(scene, rays);
    size_t count = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(judgeShadow(truth.meet(rays[i].o, rays[i].d), rays[i].tMax, results[i]), "") << "ray " << i;
        count += results[i];
    }
    EXPECT_GT(count, rays.size() / 100);
    EXPECT_LT(count, rays.size());
}

/// A hit is only one in (0, t_max): a ray that ends before its hit finds nothing, one that ends behind it finds it.
TEST_P(Traversal, RespectsTheLengthOfRays) {
    const PackedScene scene = pack(GetParam().make());
    auto rays = randomRays(2000, 66);
    const auto first = trace(scene, rays);
    auto shorter = rays, longer = rays;
    for (size_t i = 0; i < rays.size(); ++i) { shorter[i].tMax = first[i].t * 0.999f; longer[i].tMax = first[i].t * 1.001f; }
    const auto none = trace(scene, shorter), same = trace(scene, longer);
    for (size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(none[i].element, NONE);
        EXPECT_EQ(same[i].element, first[i].element);
        EXPECT_EQ(same[i].t, first[i].element == NONE ? longer[i].tMax : first[i].t);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Traversal, testing::Values(SceneCase{"triangles", triangleScene, 12000}, SceneCase{"mixed", mixedScene, 12000}, SceneCase{"curves", curveScene, 12000}, SceneCase{"instances", instancedScene, 12000}),
                         [](const auto& info) { return info.param.name; });

/// The point that a triangle's coordinates name is the point on the ray.
TEST(TraversalPoint, CoordinatesNameThePointOfTheRay) {
    const PackedScene scene = pack(triangleScene());
    const auto rays = randomRays(4000, 67);
    const auto hits = trace(scene, rays);
    for (size_t i = 0; i < rays.size(); ++i) {
        if (hits[i].element == NONE) continue;
        const shape& s = scene.tables.shapes[scene.tables.element_shapes[hits[i].element]];
        const uint* index = &scene.tables.indices[s.first_index + 3 * (hits[i].element - s.first_element)];
        const auto corner = [&](int k) { return toGlm(scene.tables.positions[s.first_vertex + index[k]]); };
        const glm::vec3 p = (1 - hits[i].u - hits[i].v) * corner(0) + hits[i].u * corner(1) + hits[i].v * corner(2), q = toGlm(rays[i].o) + hits[i].t * toGlm(rays[i].d);
        const glm::vec3 n = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
        ASSERT_LT(glm::length(p - q), 1e-5f / std::max(std::abs(glm::dot(n, toGlm(rays[i].d))), 1e-3f)) << "ray " << i;
    }
}

// ---- watertight ----------------------------------------------------------------------------------------------------------

/// A closed surface around the origin: an octahedron, each edge split `levels` times, on the sphere or left flat.
std::shared_ptr<Mesh> closedMesh(int steps, bool round) {
    auto mesh = std::make_shared<Mesh>();
    std::map<std::array<int, 3>, std::uint32_t> known;
    const auto vertex = [&](int x, int y, int z) {
        const auto [at, isNew] = known.try_emplace({x, y, z}, static_cast<std::uint32_t>(mesh->positions.size()));
        const glm::vec3 p(static_cast<float>(x) / static_cast<float>(steps), static_cast<float>(y) / static_cast<float>(steps), static_cast<float>(z) / static_cast<float>(steps));
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

/// From inside of a closed mesh, no ray escapes: aimed at vertices, at points of edges, and along axes through vertices.
TEST(Watertight, NoRayEscapesAClosedMesh) {
    for (bool round : {true, false}) {
        Scene scene;
        scene.shapes.push_back(shapeOf(TriangleMesh{closedMesh(24, round)}));
        const PackedScene packed = pack(scene);
        const auto& positions = packed.tables.positions;
        Random random(68);
        std::vector<Ray> rays;
        const auto aim = [&](vec3 o, glm::vec3 target) {
            const glm::vec3 d = glm::normalize(target - toGlm(o));
            rays.push_back({o, {d.x, d.y, d.z}});
        };
        for (int i = 0; i < 120000; ++i) {
            const vec3 o = i % 4 == 0 ? vec3{0, 0, 0} : random.box(0.15f);
            const size_t triangle = 3 * random.below(static_cast<uint>(packed.tables.indices.size() / 3));
            const glm::vec3 a = toGlm(positions[packed.tables.indices[triangle]]), b = toGlm(positions[packed.tables.indices[triangle + 1]]);
            const float s = i % 3 == 0 ? 0 : i % 3 == 1 ? 0.5f : random.unit();
            aim(o, a + s * (b - a));
            /* Along an axis, through a vertex: two coordinates are those of the vertex exactly */
            const uint axis = random.below(3);
            vec3 from{a.x, a.y, a.z};
            (axis == 0 ? from.x : axis == 1 ? from.y : from.z) = 0;
            vec3 d{0, 0, 0};
            (axis == 0 ? d.x : axis == 1 ? d.y : d.z) = random.below(2) ? 1.0f : -1.0f;
            const double inner = std::abs(static_cast<double>(from.x)) + std::abs(static_cast<double>(from.y)) + std::abs(static_cast<double>(from.z));
            const double radius = packed.tables.quadrics.empty() ? std::abs(static_cast<double>(positions[0].x)) + std::abs(static_cast<double>(positions[0].y)) + std::abs(static_cast<double>(positions[0].z)) : 1;
            if (inner < 0.9 * radius) rays.push_back({from, d});
        }
        size_t escaped = 0;
        for (const Hit& h : trace(packed, rays)) escaped += h.element == NONE;
        EXPECT_EQ(escaped, 0u) << "of " << rays.size() << (round ? " from a sphere" : " from an octahedron");
        const auto dark = blocked(packed, rays);
        EXPECT_EQ(std::count(dark.begin(), dark.end(), false), 0);
    }
}

// ---- edges of what is possible ------------------------------------------------------------------------------------------

TEST(TraversalEdges, AnEmptySceneIsMissed) {
    const PackedScene scene = pack(Scene());
    const auto rays = randomRays(500, 69);
    for (const Hit& h : trace(scene, rays)) { EXPECT_EQ(h.element, NONE); EXPECT_EQ(h.t, FAR_AWAY); }
    const auto dark = blocked(scene, rays);
    EXPECT_EQ(std::count(dark.begin(), dark.end(), true), 0);
}

/// Triangles without area change nothing: points, needles with two equal corners, three corners on a line.
TEST(TraversalEdges, DegenerateTrianglesAreNotThere) {
    Random random(70);
    Scene clean;
    clean.shapes.push_back(randomTriangles(random, 100));
    Scene dirty = clean;
    auto mesh = std::make_shared<Mesh>();
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 p = toGlm(random.box(1)), q = toGlm(random.box(1));
        for (const glm::vec3& corner : i % 3 == 0 ? std::array{p, p, p} : i % 3 == 1 ? std::array{p, p, q} : std::array{p, 0.5f * (p + q), q}) {
            mesh->indices.push_back(static_cast<std::uint32_t>(mesh->positions.size()));
            mesh->positions.push_back(corner);
        }
    }
    dirty.shapes.push_back(shapeOf(TriangleMesh{mesh}));
    /* Boxes of both scenes are equal, or their spaces would differ */
    for (Scene* s : {&clean, &dirty}) s->shapes.push_back(shapeOf(TriangleMesh{closedMesh(1, false)}, glm::dmat4(glm::dmat3(4))));
    const PackedScene a = pack(clean), b = pack(dirty);
    const auto rays = randomRays(4000, 71);
    const auto want = trace(a, rays), got = trace(b, rays);
    for (size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(got[i].t, want[i].t) << "ray " << i;
        ASSERT_EQ(got[i].element < 100, want[i].element < 100);
    }
}

/// A scene 2^60 or 2^-60 times as large is the same scene, bit by bit.
TEST(TraversalEdges, ScaleDoesNotMatter) {
    const auto rays = randomRays(3000, 72);
    const auto want = trace(pack(mixedScene()), rays);
    for (double scale : {0x1p60, 0x1p-60}) {
        Scene scene = mixedScene();
        for (Shape& s : scene.shapes) s.worldFromObject = glm::dmat4(glm::dmat3(scale)) * s.worldFromObject;
        const auto got = trace(pack(scene), rays);
        for (size_t i = 0; i < rays.size(); ++i) {
            ASSERT_EQ(got[i].element, want[i].element);
            ASSERT_EQ(got[i].t, want[i].t);
        }
    }
}

/// Tiny triangles among huge ones, and rays from far away.
TEST(TraversalEdges, SizesAndDistancesMayDifferByMillions) {
    Random random(73);
    Scene scene;
    auto mesh = std::make_shared<Mesh>();
    for (int i = 0; i < 200; ++i) {
        const float size = random.logBetween(1e-4f, 1);
        const glm::vec3 p = toGlm(random.box(1));
        for (int k = 0; k < 3; ++k) { mesh->indices.push_back(static_cast<std::uint32_t>(mesh->positions.size())); mesh->positions.push_back(p + toGlm(random.box(size))); }
    }
    scene.shapes.push_back(shapeOf(TriangleMesh{mesh}));
    const PackedScene packed = pack(scene);
    const BruteForce truth(packed);
    std::vector<Ray> rays;
    for (int i = 0; i < 4000; ++i) {
        /* At the middle of a triangle */
        const size_t first = 3 * random.below(static_cast<uint>(packed.tables.indices.size() / 3));
        const auto corner = [&](size_t k) { return toGlm(packed.tables.positions[packed.tables.indices[first + k]]); };
        const float distance = random.logBetween(0.5f, 1000);
        const glm::vec3 target = (corner(0) + corner(1) + corner(2)) / 3.0f, o = target + distance * toGlm(random.direction()), d = glm::normalize(target - o);
        if (distance < 10) rays.push_back({{o.x, o.y, o.z}, {d.x, d.y, d.z}});
    }
    const auto hits = trace(packed, rays);
    for (size_t i = 0; i < rays.size(); ++i) ASSERT_EQ(judgeHit(truth.meet(rays[i].o, rays[i].d), hits[i].element, hits[i].instance, hits[i].t), "") << "ray " << i;
}

// ---- cut-outs --------------------------------------------------------------------------------------------------------------

/// A quad cut out by a checkerboard is only there where the texture is one, whatever is behind it; nearest hits and shadow rays agree.
TEST(AlphaCutOut, OnlyWhatIsThereIsHit) {
    const PackedScene scene = packText(R"(
        WorldBegin
        Texture "holes" "float" "checkerboard" "float uscale" 4 "float vscale" 4 "float tex1" 1 "float tex2" 0
        Shape "bilinearmesh" "point3 P" [ -1 -1 0  1 -1 0  -1 1 0  1 1 0 ] "texture alpha" "holes"
        Shape "trianglemesh" "point3 P" [ -1 -1 -1  1 -1 -1  1 1 -1  -1 1 -1 ] "point2 uv" [ 0 0 1 0 1 1 0 1 ] "integer indices" [ 0 1 2 0 2 3 ] "texture alpha" "holes"
        Shape "sphere" "float radius" 0.5 "float alpha" 0)");
    ASSERT_TRUE(scene.features.has(Feature::ALPHA));
    const affine& m = scene.tables.quadrics[0].scene_from_object;
    const float scale = m.xx;
    Random random(74);
    std::vector<Ray> rays;
    std::vector<int> want;
    for (int i = 0; i < 4000; ++i) {
        const float x = random.between(-0.99f, 0.99f), y = random.between(-0.99f, 0.99f);
        rays.push_back({{m.xw + scale * x, m.yw + scale * y, m.zw + scale * 2}, {0, 0, -1}, i % 2 ? FAR_AWAY : scale * 2.5f});
        const double s = (x + 1) * 2, t = (y + 1) * 2;
        const bool near = std::min(std::abs(s - std::round(s)), std::abs(t - std::round(t))) < 1e-4;
        want.push_back(near ? -1 : (static_cast<int>(s) + static_cast<int>(t)) % 2 == 0);
    }
    const auto dark = blocked(scene, rays);
    const auto hits = trace(scene, rays);
    for (size_t i = 0; i < rays.size(); ++i) {
        if (want[i] < 0) continue;
        /* The same holes in both quads: light passes both or neither */
        ASSERT_EQ(dark[i], want[i] == 1) << "ray " << i;
        ASSERT_EQ(hits[i].element != NONE, want[i] == 1) << "ray " << i;
        if (want[i]) { ASSERT_NEAR(hits[i].t, 2 * scale, 1e-5f); }
    }
}

/// An alpha between 0 and 1 is a probability, decided by the ray alone: the same again, and the same for shadow rays.
TEST(AlphaCutOut, FractionsAreProbabilities) {
    const PackedScene scene = packText(R"(
        WorldBegin
        Shape "sphere" "float radius" 1 "float alpha" 0.3)");
    Random random(75);
    std::vector<Ray> rays;
    for (int i = 0; i < 20000; ++i) rays.push_back({{0, 0, 0}, random.direction()});
    const auto hits = trace(scene, rays), again = trace(scene, rays);
    const auto dark = blocked(scene, rays);
    double met = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(hits[i].element, again[i].element);
        ASSERT_EQ(hits[i].element != NONE, dark[i]);
        met += hits[i].element != NONE;
    }
    EXPECT_NEAR(met / 20000, 0.3, 4 * std::sqrt(0.3 * 0.7 / 20000));
}

/// Behind a hole in a shape is its far side: from outside, a ray passes a fraction f twice with probability (1 - f)^2, and ends on the near
/// side with probability f.
TEST(AlphaCutOut, TheFarSideIsSeenThroughHoles) {
    for (const char* kind : {"sphere", "cylinder"}) {
        const PackedScene scene = packText("WorldBegin Shape \"" + std::string(kind) + "\" \"float alpha\" 0.3");
        const affine& m = scene.tables.quadrics[0].scene_from_object;
        Random random(76);
        std::vector<Ray> rays;
        constexpr int count = 20000;
        for (int i = 0; i < count; ++i) rays.push_back({{m.xw + m.xx * random.between(-0.5f, 0.5f), m.yw - 3 * m.xx, m.zw + m.xx * random.between(-0.5f, 0.5f)}, {0, 1, 0}});
        const auto hits = trace(scene, rays);
        const auto dark = blocked(scene, rays);
        double near = 0, far = 0;
        for (int i = 0; i < count; ++i) {
            ASSERT_EQ(hits[i].element != NONE, dark[i]);
            if (hits[i].element != NONE) (hits[i].t < 3 * m.xx ? near : far) += 1.0 / count;
        }
        EXPECT_NEAR(near, 0.3, 4 * std::sqrt(0.3 * 0.7 / count)) << kind;
        EXPECT_NEAR(far, 0.7 * 0.3, 4 * std::sqrt(0.21 * 0.79 / count)) << kind;
    }
}

}  // namespace
}  // namespace eikonal
