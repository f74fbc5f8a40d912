// The default camera and the default light of an OBJ file.

#include "image/equal_area.h"
#include "kinds/light_kind.h"
#include "read/obj/sky.h"
#include "unit/obj_fixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace eikonal {
namespace {

class ObjView : public ObjTest {
protected:
    /// The corners of a box from (0, 0, 0) to the size: 1 to 8, x fastest, then y, then z.
    static std::string corners(double x, double y, double z) {
        std::string text;
        for (int i = 0; i < 8; ++i)
            text += "v " + std::to_string(i & 1 ? x : 0) + " " + std::to_string(i & 2 ? y : 0) + " " + std::to_string(i & 4 ? z : 0) + "\n";
        return text;
    }
    static inline const std::string outwards = "f 1 3 4 2\nf 1 2 6 5\nf 1 5 7 3\nf 2 4 8 6\nf 3 7 8 4\n", front = "f 5 6 8 7\n";
    static inline const std::string inwards = "f 2 4 3 1\nf 5 6 2 1\nf 3 7 5 1\nf 6 8 4 2\nf 4 8 7 3\n";

    static glm::dvec3 eye(const Scene& scene) { return scene.camera.worldFromCamera[3]; }
    static glm::dvec3 forward(const Scene& scene) { return scene.camera.worldFromCamera[2]; }

    /// Where a point is in the image: x and y in [-1, 1] inside, along the shorter side of the image; z the distance.
    static glm::dvec3 project(const Scene& scene, glm::dvec3 p) {
        const glm::dvec3 c = glm::inverse(scene.camera.worldFromCamera) * glm::dvec4(p, 1);
        const double t = std::tan(scene.camera.fov / 2 * std::numbers::pi / 180);
        return {c.x / c.z / t, c.y / c.z / t, c.z};
    }
};

// A solid is seen from its right, front and above, whole, and fills most of the image.
TEST_F(ObjView, showsAllOfASolid) {
    for (const double size : {1e-3, 1., 1e6}) {
        const Scene scene = load(corners(size, size, size) + outwards + front);
        const glm::dvec3 towards = glm::normalize(eye(scene) - glm::dvec3(size / 2));
        EXPECT_GT(towards.x, .2);
        EXPECT_GT(towards.y, .2);
        EXPECT_GT(towards.z, .2);
        double farthest = 0;
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 q = project(scene, glm::dvec3(i & 1, i >> 1 & 1, i >> 2) * size);
            EXPECT_GT(q.z, 0);
            farthest = std::max({farthest, std::abs(q.x), std::abs(q.y)});
        }
        EXPECT_LT(farthest, 1);
        EXPECT_GT(farthest, .8);
    }
}

// Seen from all sides, the model stays whole in an image of one size, from one distance, and fills most of it once.
TEST_F(ObjView, suitsAWholeTurn) {
    for (const glm::dvec3& size : {glm::dvec3(1, 1, 1), {5, .2, 1}, {.1, 4, .2}}) {
        constexpr int steps = 48;
        double farthest = 0;
        glm::dvec3 first(0);
        for (int step = 0; step < steps; ++step) {
            const Scene scene = load(corners(size.x, size.y, size.z) + outwards + front, {.turns = step / double(steps)});
            if (step == 0) first = eye(scene) - size / 2.;
            const glm::dvec3 arm = eye(scene) - size / 2.;
            EXPECT_NEAR(arm.y, first.y, 1e-9 * glm::length(first));
            EXPECT_NEAR(glm::length(arm), glm::length(first), 1e-9 * glm::length(first));
            const double turned = glm::distance(arm, {first.z, first.y, -first.x});
            EXPECT_TRUE(step != steps / 4 || turned < 1e-6) << "counter-clockwise from above";
            const double shorter = std::min(scene.film.width, scene.film.height);
            for (int i = 0; i < 8; ++i) {
                const glm::dvec3 q = project(scene, glm::dvec3(i & 1, i >> 1 & 1, i >> 2) * size);
                EXPECT_GT(q.z, 0);
                farthest = std::max({farthest, std::abs(q.x) * shorter / scene.film.width, std::abs(q.y) * shorter / scene.film.height});
            }
        }
        EXPECT_LT(farthest, 1 / 1.049);
        EXPECT_GT(farthest, .9);
    }
}

// A box that is open in front, like Cornell's, is looked into straight from the front.
TEST_F(ObjView, looksIntoAnOpenBox) {
    const Scene scene = load(corners(2, 2, 2) + inwards);
    EXPECT_NEAR(eye(scene).x, 1, 1e-6);
    EXPECT_NEAR(eye(scene).y, 1, 1e-6);
    EXPECT_GT(eye(scene).z, 2);
    EXPECT_NEAR(forward(scene).z, -1, 1e-6);
}

// A closed room is seen from inside.
TEST_F(ObjView, standsInAClosedRoom) {
    const Scene scene = load(corners(4, 3, 5) + inwards + "f 7 8 6 5\n");
    const glm::dvec3 e = eye(scene);
    EXPECT_TRUE(e.x > 0 && e.x < 4 && e.y > 0 && e.y < 3 && e.z > 0 && e.z < 5) << e.x << " " << e.y << " " << e.z;
}

TEST_F(ObjView, obeysItsOptions) {
    const Scene scene =
        load(corners(1, 1, 1) + outwards + front,
             {.camera = glm::dvec3(5, 6, 7), .lookAt = glm::dvec3(0, 6, 7), .up = {0, 0, 1}, .fov = 30, .width = 320, .height = 200});
    EXPECT_LT(glm::distance(eye(scene), glm::dvec3(5, 6, 7)), 1e-9);
    EXPECT_LT(glm::distance(forward(scene), glm::dvec3(-1, 0, 0)), 1e-9);
    EXPECT_LT(glm::distance(glm::dvec3(scene.camera.worldFromCamera[1]), glm::dvec3(0, 0, 1)), 1e-9);
    EXPECT_EQ(scene.camera.fov, 30);
    EXPECT_EQ(scene.film.width, 320);
    EXPECT_EQ(scene.film.height, 200);
}

TEST_F(ObjView, refusesImpossibleOptions) {
    const std::string cube = corners(1, 1, 1) + outwards;
    const auto code = [&](const ObjOptions& options) {
        try {
            load(cube, options);
        } catch (const UsageError& error) {
            return error.code();
        }
        return ExitCode::success;
    };
    for (const ObjOptions& options : {ObjOptions{.fov = 0}, ObjOptions{.fov = 180}, ObjOptions{.up = {0, 0, 0}}, ObjOptions{.width = 0},
                                      ObjOptions{.height = -3}, ObjOptions{.camera = glm::dvec3(1), .lookAt = glm::dvec3(1)}})
        EXPECT_EQ(code(options), ExitCode::usage);
}

// x and y of camera space, and z along the view, as pbrt's camera has them: seen from +z with y up, +x is to the right.
TEST_F(ObjView, isNotMirrored) {
    const Scene scene = load(corners(1, 1, 1) + outwards, {.camera = glm::dvec3(.5, .5, 9), .lookAt = glm::dvec3(.5, .5, 0)});
    EXPECT_GT(project(scene, {1, .5, 0}).x, 0);
    EXPECT_GT(project(scene, {.5, 1, 0}).y, 0);
}

// The sky's promise: a white horizontal surface in the open has a radiance of about 0.8, that is E / pi with the irradiance E summed over
// directions.
TEST_F(ObjView, isLitByASkyIfNothingEmits) {
    const Scene scene = load(corners(1, 1, 1) + outwards);
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].kind->value, kind_image_infinite_light);
    EXPECT_GT(scene.lights[0].worldFromLight[2].y, .999);  // its zenith is up

    glm::dvec3 irradiance(0);
    constexpr int zenithSteps = 400, azimuthSteps = 800;
    for (int i = 0; i < zenithSteps; ++i)
        for (int j = 0; j < azimuthSteps; ++j) {
            const double z = (i + .5) / zenithSteps, phi = 2 * std::numbers::pi * (j + .5) / azimuthSteps, r = std::sqrt(1 - z * z);
            irradiance +=
                skyRadiance({r * std::cos(phi), r * std::sin(phi), z}) * z * (2 * std::numbers::pi / (double(zenithSteps) * azimuthSteps));
        }
    EXPECT_NEAR(irradiance.y / std::numbers::pi, .8, .05);

    /* Its image, which is made faster, is that of the same sky */
    EXPECT_TRUE(scene.images.at(static_cast<std::size_t>(scene.lights[0].image)).pixels->floats ==
                equalAreaImage(512, 3, skyRadiance).floats);
}

}  // namespace
}  // namespace eikonal
