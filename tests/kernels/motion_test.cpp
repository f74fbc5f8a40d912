// Motion on the device, against double precision: the maps, and what rays of different times meet.

#include "brute_force.h"
#include "device_function.h"
#include "pack/motion.h"
#include "random_inputs.h"
#include "stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

glm::dmat4 toMatrix(const affine& m) { return {m.xx, m.yx, m.zx, 0, m.xy, m.yy, m.zy, 0, m.xz, m.yz, m.zz, 0, m.xw, m.yw, m.zw, 1}; }

double distance(const glm::dmat4& a, const glm::dmat4& b) {
    double most = 0, size = 0;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) { most = std::max(most, std::abs(a[c][r] - b[c][r])); size = std::max(size, std::abs(b[c][r])); }
    return most / size;
}

struct Motions {
    std::vector<Motion> exact;
    std::vector<motion> packed;
    std::vector<float> times;
    SceneSpace scene{{5, -3, 900}, 0.25}, group{{4, 0, 880}, 2};
};

/// Turns, stretchings and ways of all sizes, mirrored ones among them, far from the origin.
Motions manyMotions(size_t n) {
    Random random(7);
    const auto vector = [&](float size) { const vec3 v = random.box(size); return glm::dvec3(v.x, v.y, v.z); };
    const auto map = [&] {
        const vec3 axis = random.direction();
        glm::dmat4 m = glm::translate(glm::dmat4(1), glm::dvec3(5, -3, 900) + vector(3));
        m = glm::rotate(m, static_cast<double>(random.logBetween(1e-5f, 3.1f)), glm::dvec3(axis.x, axis.y, axis.z));
        return glm::scale(m, glm::dvec3(random.logBetween(0.3f, 3), random.logBetween(0.3f, 3), random.logBetween(0.3f, 3)));
    };
    Motions all;
    for (size_t i = 0; i < n; ++i) {
        const glm::dmat4 mirror = glm::scale(glm::dmat4(1), {i % 3 ? 1 : -1, 1, 1}), start = map() * mirror;
        all.exact.push_back({start, i % 5 ? map() * mirror : start});
        all.packed.push_back(all.exact.back().pack(all.scene, all.group));
        all.times.push_back(i % 11 ? random.unit() : static_cast<float>(i % 2));
    }
    return all;
}

TEST(Motion, DeviceInterpolatesAsTheHost) {
    const Motions all = manyMotions(2000);
    const DeviceFunction<affine> at(
        {.include = "trace/motion.clh", .type = "affine", .body = "result = place_at(m, time);", .inputs = {"motion m", "float time"}});
    const auto results = at(all.packed, all.times);
    for (size_t i = 0; i < results.size(); ++i) {
        const glm::dmat4 expected =
            all.scene.sceneFromWorld() * all.exact[i].at(static_cast<double>(all.times[i])) * all.group.worldFromScene();
        /* The centre is 880 away, and turns with the rest: what is lost of it is lost in single precision */
        ASSERT_LT(distance(toMatrix(results[i]), expected), 5e-6) << i;
    }
}

TEST(Motion, InverseIsTheInverse) {
    const Motions all = manyMotions(2000);
    const DeviceFunction<affine> both(
        {.include = "trace/motion.clh",
         .type = "affine",
         .body = "affine m0 = place_at(m, time); m0.xw *= 1e-2f; m0.yw *= 1e-2f; m0.zw *= 1e-2f; result = compose(invert(m0), m0);",
         .inputs = {"motion m", "float time"}});
    for (const affine& m : both(all.packed, all.times)) ASSERT_LT(distance(toMatrix(m), glm::dmat4(1)), 1e-4);
}

/// The definition of include/eikonal/motion.h, in double precision.
glm::dmat4 mapAt(const motion& m, double t) {
    const auto blend = [&](float a, float b) { return static_cast<double>(a) * (1 - t) + static_cast<double>(b) * t; };
    const double angle = static_cast<double>(m.angle), a = angle > 0 ? std::sin((1 - t) * angle) / std::sin(angle) : 1 - t,
                 b = angle > 0 ? std::sin(t * angle) / std::sin(angle) : t;
    const auto turn = [&](float p, float q) { return a * static_cast<double>(p) + b * static_cast<double>(q); };
    const glm::dquat q = glm::normalize(glm::dquat(turn(m.start_rotation.w, m.end_rotation.w), turn(m.start_rotation.x, m.end_rotation.x),
                                                   turn(m.start_rotation.y, m.end_rotation.y), turn(m.start_rotation.z, m.end_rotation.z)));
    const glm::dmat4 start = toMatrix(m.start), end = toMatrix(m.end);
    const glm::dmat3 stretch = glm::dmat3(start) * (1 - t) + glm::dmat3(end) * t;
    glm::dmat4 r(glm::mat3_cast(q) * stretch);
    r[3] = glm::dvec4(blend(m.start.xw, m.end.xw), blend(m.start.yw, m.end.yw), blend(m.start.zw, m.end.zw), 1);
    return r * glm::translate(glm::dmat4(1), glm::dvec3(m.centre.x, m.centre.y, m.centre.z));
}

constexpr const char* world = R"(
    TransformTimes 0 1
    WorldBegin
    Shape "sphere" "float radius" 0.5
    AttributeBegin Translate 0 1 0 ActiveTransform EndTime Translate 1 0.5 0 Rotate 140 1 2 3 Scale 2 1 0.5 ActiveTransform All
        Shape "trianglemesh" "integer indices" [ 0 1 2 0 2 3 0 3 1 1 3 2 ] "point3 P" [ 0 0 0  1 0 0  0 1 0  0 0 1 ] Shape "disk"
            AttributeEnd
    ObjectBegin "a"
        Shape "sphere" "float radius" 0.3
        AttributeBegin Translate 0.8 0 0 ActiveTransform EndTime Rotate 90 0 0 1 ActiveTransform All
            Shape "bilinearmesh" "point3 P" [ 0 0 0  1 0 0  0 1 0  1 1 1 ] AttributeEnd
    ObjectEnd
    AttributeBegin Translate -2 0 0 ObjectInstance "a" AttributeEnd
    AttributeBegin Translate 2 0 0 ActiveTransform EndTime Translate 0 -3 0 Rotate 60 0 1 0 ActiveTransform All ObjectInstance "a"
        AttributeEnd)";

/// At each of some times rays meet what brute force meets in the scene as it is then.
TEST(Motion, RaysMeetWhatIsThereAtTheirTime) {
    const PackedScene scene = packText(world);
    ASSERT_TRUE(scene.features.has(Feature::MOTION));
    constexpr size_t n = 4096;
    size_t hits = 0;
    for (float time : {0.0f, 0.35f, 0.8f, 1.0f}) {
        Random random(3);
        StageBench bench(scene, n);
        QueueWords queue = bench.empty("ray"), shadows = bench.empty("shadow");
        for (size_t i = 0; i < n; ++i) {
            vec3 o = random.box(1), d = random.direction();
            if (i % 2) {
                const vec3 at = random.box(0.7f);
                d = {at.x - o.x, at.y - o.y, at.z - o.z};
                const float s = 1 / static_cast<float>(std::sqrt(dot(d, d)));
                d = {d.x * s, d.y * s, d.z * s};
            }
            for (QueueWords* q : {&queue, &shadows}) { q->set("o", i, o); q->set("d", i, d); q->set("time", i, time); }
            queue.set("t_max", i, FAR_AWAY);
            shadows.set("t_max", i, 0.5f);
            shadows.set("path", i, static_cast<uint>(i));
            shadows.set("Ld", i, spectrum{1, 2, 3});
        }
        bench.write("ray", queue);
        bench.write("shadow", shadows);
        bench.resetCounters();
        bench.run("intersect_rays", n);
        bench.run("test_shadows", n);
        const QueueWords intersections = bench.read("intersection"), paths = bench.read("path");

        PackedScene then = scene;
        for (instance& i : then.tables.instances) {
            if (!i.motion_count) continue;
            glm::dmat4 m(1);
            for (uint k = 0; k < i.motion_count; ++k) m = m * mapAt(then.tables.motions[i.first_motion + k], static_cast<double>(time));
            i.scene_from_object = toAffine(m);
            i.object_from_scene = toAffine(glm::inverse(m));
        }
        const BruteForce truth(then);
        for (size_t i = 0; i < n; ++i) {
            const auto all = truth.meet(queue.get<vec3>("o", i), queue.get<vec3>("d", i));
            const uint element = intersections.get<uint>("element", i);
            hits += element != NONE;
            ASSERT_EQ(judgeHit(all, element, intersections.get<uint>("instance", i), static_cast<double>(intersections.get<float>("t", i))),
                      "")
                << "time " << time << " ray " << i;
            ASSERT_EQ(judgeShadow(all, 0.5, paths.get<spectrum>("L", i).b == 0), "") << "time " << time << " shadow ray " << i;
        }
    }
    EXPECT_GT(hits, n / 10);
}

}  // namespace
}  // namespace eikonal
