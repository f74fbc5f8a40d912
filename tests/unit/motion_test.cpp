// Motions on the host: transforms taken apart and put together, and bounds that hold.

#include "pack/motion.h"
#include "pack/pack.h"
#include "unit/pbrt_reading.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace eikonal {
namespace {

glm::dmat4 turned(double degrees, glm::dvec3 axis) { return glm::rotate(glm::dmat4(1), glm::radians(degrees), axis); }
glm::dmat4 moved(glm::dvec3 by) { return glm::translate(glm::dmat4(1), by); }
glm::dmat4 scaled(glm::dvec3 by) { return glm::scale(glm::dmat4(1), by); }

const std::vector<glm::dmat4> maps{glm::dmat4(1),
                                   moved({3, -2, 900}),
                                   turned(170, {1, 2, 3}) * scaled({2, 2, 2}),
                                   moved({0, 1, 0}) * scaled({-1, 1, 1}) * turned(40, {0, 1, 0}),
                                   turned(30, {0, 0, 1}) * scaled({1e-3, 4, 500}) * turned(-75, {1, 1, 0}),
                                   scaled({1e-6, 1e-6, 1e-6}) * turned(90, {0, 1, 0})};

double distance(const glm::dmat4& a, const glm::dmat4& b) {
    double most = 0, size = 0;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) { most = std::max(most, std::abs(a[c][r] - b[c][r])); size = std::max(size, std::abs(b[c][r])); }
    return most / size;
}

/// A map is its stretching, which is symmetric, then its rotation, which is proper.
TEST(Motion, TakesMapsApart) {
    for (const glm::dmat4& m : maps) {
        const Decomposition d = decompose(m);
        EXPECT_LT(distance(glm::dmat4(d.rotation * d.stretch), glm::dmat4(glm::dmat3(m))), 1e-12);
        EXPECT_LT(distance(glm::dmat4(d.rotation * glm::transpose(d.rotation)), glm::dmat4(1)), 1e-12);
        EXPECT_NEAR(glm::determinant(d.rotation), 1, 1e-12);
        EXPECT_LT(distance(glm::dmat4(glm::transpose(d.stretch)), glm::dmat4(d.stretch)), 1e-9);
    }
}

TEST(Motion, BeginsAndEndsWhereItShould) {
    for (const glm::dmat4& a : maps)
        for (const glm::dmat4& b : maps) {
            EXPECT_LT(distance(Motion(a, b).at(0), a), 1e-9);
            EXPECT_LT(distance(Motion(a, b).at(1), b), 1e-9);
        }
}

/// Half of a quarter turn about z, of a doubling, and of a way.
TEST(Motion, InterpolatesEachPart) {
    const Motion m(glm::dmat4(1), moved({4, 0, 6}) * turned(90, {0, 0, 1}) * scaled({3, 3, 3}));
    EXPECT_LT(distance(m.at(0.5), moved({2, 0, 3}) * turned(45, {0, 0, 1}) * scaled({2, 2, 2})), 1e-12);
    EXPECT_LT(distance(m.at(0.25), moved({1, 0, 1.5}) * turned(22.5, {0, 0, 1}) * scaled({1.5, 1.5, 1.5})), 1e-12);
}

/// All corners at many times are in the bounds, which are not much larger, unless they are of boxes in turned boxes.
TEST(Motion, BoundsHold) {
    const Box box{{-1, 2, -3}, {1, 2.5, 4}};
    for (const glm::dmat4& a : maps)
        for (const glm::dmat4& b : maps)
            for (const TimeSpan span : {TimeSpan{0, 1}, TimeSpan{0.2, 0.4}, TimeSpan{0.5, 0.5}})
                for (const std::vector<Motion>& motions : {std::vector<Motion>{{a, b}}, {{a, b}, {maps[2], maps[3]}}}) {
                    const Box bounds = boundsInMotion(motions, box, span);
                    Box reached;
                    for (int i = 0; i <= 1000; ++i) {
                        const double t = span.from + (span.to - span.from) * i / 1000;
                        glm::dmat4 m(1);
                        for (const Motion& each : motions) m = m * each.at(t);
                        reached.grow(transformed(box, m));
                    }
                    const double rounding = 1e-9 * reached.radius();
                    for (int k = 0; k < 3; ++k) {
                        ASSERT_LE(bounds.low[k], reached.low[k] + rounding);
                        ASSERT_GE(bounds.high[k], reached.high[k] - rounding);
                    }
                    if (motions.size() == 1) { ASSERT_LT(bounds.radius(), 1.01 * reached.radius()); }
                }
}

class PbrtMotion : public PbrtTest {};

/// Only transforms that are active change; everything that is described has both.
TEST_F(PbrtMotion, CamerasShapesAndInstancesMove) {
    const Scene scene = read(R"(TransformTimes 2 6
        ActiveTransform EndTime Translate 0 0 5 ActiveTransform All Camera "perspective" "float shutteropen" 3 "float shutterclose" 4
        WorldBegin ActiveTransform StartTime Scale 2 2 2 ActiveTransform All Shape "sphere"
        ObjectBegin "a" Shape "disk" ObjectEnd ObjectInstance "a" ActiveTransform EndTime Scale 2 2 2 Shape "sphere")");
    EXPECT_TRUE(warnings_.empty());
    EXPECT_EQ(scene.motionStart, 2);
    EXPECT_EQ(scene.motionEnd, 6);
    ASSERT_TRUE(scene.camera.worldFromCameraAtEnd);
    EXPECT_EQ((*scene.camera.worldFromCameraAtEnd)[3].z, -5);
    ASSERT_TRUE(scene.shapes[0].worldFromObjectAtEnd && scene.objects[0].shapes[0].worldFromObjectAtEnd &&
                scene.instances[0].worldFromObjectAtEnd);
    EXPECT_EQ(scene.shapes[0].worldFromObject[0].x, 2);
    EXPECT_EQ((*scene.shapes[0].worldFromObjectAtEnd)[0].x, 1);
    EXPECT_FALSE(scene.shapes[1].worldFromObjectAtEnd) << "both are scaled alike again";
    EXPECT_EQ(timesSeen(scene).from, 0.25);
    EXPECT_EQ(timesSeen(scene).to, 0.5);
}

TEST_F(PbrtMotion, WhatCannotBeIsNamed) {
    EXPECT_THAT(errorOf("TransformTimes 1 1\nWorldBegin"), HasSubstr("test.pbrt:1:1: TransformTimes are a start and an end after it"));
    EXPECT_THAT(
        errorOfWorld(
            "ActiveTransform EndTime Scale 1 0 1\nShape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 2]"),
        HasSubstr("test.pbrt:3:1: the transform of something that moves cannot be inverted"));
    EXPECT_THAT(warningsOfWorld("AreaLightSource \"diffuse\" ActiveTransform EndTime Translate 1 0 0 Shape \"sphere\""),
                ElementsAre(HasSubstr("a moving shape cannot emit")));
}

/// A scene is as large as what moves in it gets while the shutter is open.
TEST_F(PbrtMotion, TheSceneHoldsAllOfTheMotion) {
    const auto pack = [&](const std::string& text) {
        Diagnostics diagnostics(LogLevel::silent);
        return packScene(read(text), diagnostics);
    };
    const std::string far = "WorldBegin ActiveTransform EndTime Translate 100 0 0 Shape \"sphere\"";
    EXPECT_EQ(pack("Camera \"perspective\" " + far).worldScale, 64);
    EXPECT_EQ(pack("Camera \"perspective\" \"float shutterclose\" 0.01 " + far).worldScale, 4);
    EXPECT_NEAR(pack("Camera \"perspective\" " + far).worldCenter.x, 50, 1e-9);
}

}  // namespace
}  // namespace eikonal
