// A sphere that is given by a formula is a sphere: whatever is done to it, the image is that of the quadric.

#include "rendering.h"

namespace eikonal {
namespace {

const std::string quadric = "Shape \"sphere\"", formula = "Shape \"implicit\" \"string F\" \"x^2 + y^2 + z^2 - 1\" \"point3 bounds\" [-1.1 -1.1 -1.1  1.1 1.1 1.1]";

/// Nearly every path finds the same points, so that the images are far closer to each other than to their expectation.
void expectSameImage(const std::string& before, const std::string& after) {
    View view;
    view.lookAt = "0 2 -6  0 .6 0  0 1 0";
    view.fov = 35;
    view.width = view.height = 32;
    view.samples = 64;
    view.maxDepth = 8;
    const std::string room = R"(LightSource "infinite" "rgb L" [.3 .4 .5]
        AttributeBegin AreaLightSource "diffuse" "rgb L" [20 18 15] Translate 1 4 -1 Rotate 90 1 0 0 Shape "disk" "float radius" .5 AttributeEnd
        Material "diffuse" "rgb reflectance" [.6 .5 .4] Shape "bilinearmesh" "point3 P" [-5 -.5 -5  5 -.5 -5  -5 -.5 5  5 -.5 5] )";
    /* The same kernels for both, in which directions along the surface, which are not the same, have no part */
    RenderSetup both;
    both.forced.require(Feature::SHAPE_SPHERE).require(Feature::SHAPE_IMPLICIT).require(Feature::INSTANCES);
    const Rendered a = render(sceneText(view, room + before + quadric + after), both), b = render(sceneText(view, room + before + formula + after), both);
    EXPECT_EQ(a.invalid.count + b.invalid.count, 0u);
    const Estimate x = estimate(a.image), y = estimate(b.image);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(x.mean[c], y.mean[c], 0.01 * x.mean[c]) << before;
    size_t different = 0;
    for (size_t i = 0; i < a.image.color.size(); ++i) different += std::abs(a.image.color[i].g - b.image.color[i].g) > 0.02f * a.image.color[i].g;
    EXPECT_LT(different, a.image.color.size() / 10) << before;
}

TEST(Implicit, ABallIsABall) {
    const std::string stretched = "Translate .3 .7 0 Rotate 40 1 2 3 Scale 1.2 -.7 .9 ";
    /* Not a coat, whose walk draws its numbers from the bits of directions */
    expectSameImage("Material \"conductor\" \"float roughness\" .3 ReverseOrientation " + stretched, "");
    expectSameImage("Translate 0 .6 0 Material \"dielectric\" \"float eta\" 1.5 ", "");
    expectSameImage("Material \"diffuse\" ObjectBegin \"a\" " + stretched, "ObjectEnd ObjectInstance \"a\" Translate -1.5 0 1 Scale .5 .5 .5 ObjectInstance \"a\"");
}

/// Half of its points are cut out; which half a ray meets is drawn by its bits, so that only means agree.
TEST(Implicit, IsCutOutByAlpha) {
    View view;
    view.lookAt = "0 0 -4  .2 .1 0  0 1 0";
    const auto seen = [&](const std::string& shape) {
        return render(sceneText(view, "LightSource \"infinite\" \"rgb L\" [1 .5 0] Material \"diffuse\" \"rgb reflectance\" [0 0 0] " + shape + " \"float alpha\" .5"), surfaces());
    };
    /* Black, but for a fourth of the rays that pass its front and its back */
    expectRadiance(seen(formula), glm::dvec3(.25, .125, 0), 0.02);
}

/// Black in a white world, it covers the pixel while it passes: a fourth of the time.
TEST(Implicit, Moves) {
    View view;
    view.samples = 1024;
    expectRadiance(render(sceneText(view, R"(LightSource "infinite" "rgb L" [1 1 1] Material "diffuse" "rgb reflectance" [0 0 0]
        ActiveTransform EndTime Translate 8 0 0 ActiveTransform All Translate -4 0 0 )" + formula)), 0.75);
}

}  // namespace
}  // namespace eikonal
