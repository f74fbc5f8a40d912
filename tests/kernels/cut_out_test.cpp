// Shapes that an alpha cuts holes into: nearest hits and shadow rays find the same holes.

#include "brute_force.h"
#include "stage.h"
#include "traversal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace eikonal {
namespace {

/// A quad cut out by a checkerboard is only there where the texture is one, whatever is behind it; nearest hits and shadow rays agree.
TEST(AlphaCutOut, OnlyWhatIsThereIsHit) {
    const PackedScene scene = packText(R"(
        WorldBegin
        Texture "holes" "float" "checkerboard" "float uscale" 4 "float vscale" 4 "float tex1" 1 "float tex2" 0
        Shape "bilinearmesh" "point3 P" [ -1 -1 0  1 -1 0  -1 1 0  1 1 0 ] "texture alpha" "holes"
        Shape "trianglemesh" "point3 P" [ -1 -1 -1  1 -1 -1  1 1 -1  -1 1 -1 ] "point2 uv" [ 0 0 1 0 1 1 0 1 ]
            "integer indices" [ 0 1 2 0 2 3 ] "texture alpha" "holes"
        Shape "sphere" "float radius" 0.5 "float alpha" 0)");
    ASSERT_TRUE(scene.features.has(Feature::ALPHA));
    const object_space& sphere = scene.tables.object_spaces[0];
    const affine& m = sphere.scene_from_object;
    const vec3 center = placedCenter(sphere);
    const float scale = m.xx * sphere.radius / 0.5f;
    Random random(74);
    std::vector<Ray> rays;
    std::vector<int> want;
    for (int i = 0; i < 4000; ++i) {
        const float x = random.between(-0.99f, 0.99f), y = random.between(-0.99f, 0.99f);
        rays.push_back({{center.x + scale * x, center.y + scale * y, center.z + scale * 2}, {0, 0, -1}, i % 2 ? FAR_AWAY : scale * 2.5f});
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
        const affine& m = scene.tables.object_spaces[0].scene_from_object;
        const vec3 center = placedCenter(scene.tables.object_spaces[0]);
        Random random(76);
        std::vector<Ray> rays;
        constexpr int count = 20000;
        for (int i = 0; i < count; ++i)
            rays.push_back({{center.x + m.xx * random.between(-0.5f, 0.5f), center.y - 3 * m.xx,
                             center.z + m.xx * random.between(-0.5f, 0.5f)}, {0, 1, 0}});
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
