// Motion against derived values: how long a pixel sees what passes, how long a shadow lasts, and that light is kept.

#include "rendering.h"

#include <fmt/format.h>

#include <cmath>

namespace eikonal {
namespace {

/// Every pixel sees the same point, where a black square of side 2 passes during a fourth of the motion's time: 8 units to go.
constexpr const char* passingSquare = R"(LightSource "infinite" "rgb L" [1 1 1]
AttributeBegin ActiveTransform EndTime Translate 8 0 0 ActiveTransform All Translate -4 0 0
Material "diffuse" "rgb reflectance" [0 0 0] Shape "bilinearmesh" "point3 P" [-1 -1 0  1 -1 0  -1 1 0  1 1 0] AttributeEnd)";

View view(const std::string& more = "") {
    View v;
    v.samples = 1024;
    v.more = more;
    return v;
}

TEST(Motion, ASquareIsSeenWhileItPasses) { expectRadiance(render(sceneText(view(), passingSquare)), 0.75); }

/// The square is there from 0.375 to 0.625. What the film misses in a shorter time its speed makes up for.
TEST(Motion, TheShutterSaysWhichPart) {
    const auto world = [](double open, double close) {
        return "Camera \"perspective\" \"float fov\" 0.02 \"float shutteropen\" " + std::to_string(open) + " \"float shutterclose\" " +
               std::to_string(close) + "\nFilm \"rgb\" \"integer xresolution\" 16 \"integer yresolution\" 16 \"float iso\" " +
               std::to_string(100 / (close - open));
    };
    expectRadiance(render(sceneText(view(world(0.5, 1)), passingSquare)), 0.75);
    expectRadiance(render(sceneText(view(world(0.25, 0.5)), passingSquare)), 0.5);
    expectRadiance(render(sceneText(view(world(1.5, 2)), passingSquare)), 1);
    expectRadiance(render(sceneText(view("TransformTimes -1 1\n" + world(-0.2, 0.2)), passingSquare)), 0);
}

/// The same square in an instance that moves against it: it stays where it is.
TEST(Motion, InstancesAndTheirShapesMoveTogether) {
    const std::string world = R"(LightSource "infinite" "rgb L" [1 1 1] Material "diffuse" "rgb reflectance" [0 0 0]
ObjectBegin "a" ActiveTransform EndTime Translate 8 0 0 ActiveTransform All Shape "bilinearmesh" "point3 P" [-1 -1 0  1 -1 0  -1 1 0  1 1 0]
    ObjectEnd
AttributeBegin ActiveTransform EndTime Translate -8 0 0 ActiveTransform All Translate 0.5 0 0 ObjectInstance "a" AttributeEnd)";
    expectRadiance(render(sceneText(view(), world)), 0);
}

/// A disk between a point light and a white floor covers the point that is seen during half of the time: irradiance I / d^2 / 2, radiance
/// that times 0.8 / pi.
TEST(Motion, ShadowsMove) {
    View v = view();
    v.lookAt = "3 3 0  0 0 0  0 1 0";
    v.maxDepth = 1;
    const std::string world = R"(LightSource "point" "rgb I" [10 10 10] "point3 from" [0 5 0]
Material "diffuse" "rgb reflectance" [.8 .8 .8] Shape "bilinearmesh" "point3 P" [-9 0 -9  9 0 -9  -9 0 9  9 0 9]
AttributeBegin ActiveTransform EndTime Translate 4 0 0 ActiveTransform All Translate -2 4 0 Rotate 90 1 0 0
Shape "disk" "float radius" 1 AttributeEnd)";
    expectRadiance(render(sceneText(v, world)), 10.0 / 25 / 2 * 0.8 / M_PI);
}

/// Black smoke, in front of a white sky, passes the point that is seen during a fourth of the time. From the middle of the grid's only cell
/// its density falls from 1 to 1/2 at the borders along each axis, so along the ray it is 2 thick, with a mean of 3/4.
TEST(Motion, SmokeIsSeenWhileItPasses) {
    const std::string world = R"(LightSource "infinite" "rgb L" [1 1 1]
AttributeBegin ActiveTransform EndTime Translate 8 0 0 ActiveTransform All Translate -4 0 0 Translate -1 -1 -1 Scale 2 2 2
MakeNamedMedium "smoke" "string type" "rgbgrid" "integer nx" 1 "integer ny" 1 "integer nz" 1 "rgb sigma_a" [1 1 1] "rgb sigma_s" [0 0 0]
AttributeEnd
MediumInterface "smoke" "" Material "interface" Shape "sphere" "float radius" 20)";
    View v = view();
    v.lookAt = "0 0 -30  0 0 0  0 1 0";
    const double passed = 2 * std::exp(-0.75) * (1 - std::exp(-0.75)) / 1.5;   // the mean of exp(-3/2 w), w from 1/2 to 1
    expectRadiance(render(sceneText(v, world)), 0.75 + 0.25 * passed);
}

/// In the middle of its motion a cloud that turns and moves is where a still one was put there.
TEST(Motion, AMediumInTheMiddleIsAStillOneThere) {
    const auto seen = [](const std::string& place) {
        View v = view("Camera \"perspective\" \"float fov\" 0.02 \"float shutteropen\" 0.495 \"float shutterclose\" 0.505\n");
        v.lookAt = "1 1 -5  .5 .2 .5  0 1 0";
        return render(sceneText(v, "LightSource \"point\" \"rgb I\" [20 10 9] \"point3 from\" [2 3 -3] AttributeBegin " + place + R"(
MakeNamedMedium "smoke" "string type" "uniformgrid" "integer nx" 2 "integer ny" 2 "integer nz" 2 "float density" [1 0 3 2 5 1 0 4]
    "rgb sigma_a" [.1 .2 .3] "rgb sigma_s" [2 1 3] AttributeEnd
MediumInterface "smoke" "" Material "interface" Shape "sphere" "float radius" 3)"));
    };
    expectEqualMeans(seen("ActiveTransform EndTime Translate 1 -.5 .5 Rotate 80 1 2 3 Scale 3 1 1"),
                     seen("Translate .5 -.25 .25 Rotate 40 1 2 3 Scale 2 1 1"), 0.05);
    expectEqualMeans(seen("ActiveTransform EndTime Translate 1 -.5 .5"), seen("Translate .5 -.25 .25"), 0.05);
}

/// A white ball that moves, turns and grows in a white world cannot be seen: no ray meets the surface that it leaves.
TEST(Motion, AWhiteBallVanishes) {
    View v = view();
    v.fov = 30;
    v.width = v.height = 24;
    v.samples = 64;
    v.maxDepth = 100;
    const std::string world = R"(LightSource "infinite" "rgb L" [1 1 1] Material "diffuse" "rgb reflectance" [1 1 1]
AttributeBegin ActiveTransform EndTime Translate 1 .2 -.5 Rotate 150 1 2 3 Scale 2 1 .5 ActiveTransform All Translate -.5 0 0 Shape "sphere"
    AttributeEnd)";
    expectRadiance(render(sceneText(v, world)), 1, 1e-3);
}

/// A curve that moves is in the shadow of another that moves with it, two widths away: new rays begin one width away, as on a curve that
/// rests.
TEST(Motion, CurvesShadeOneAnother) {
    const auto seen = [](const std::string& motion, double shadeWidth) {
        return render(sceneText(view(), fmt::format(R"(LightSource "distant" "rgb L" [1 1 1] "point3 from" [0 1 -1] "point3 to" [0 0 0]
AttributeBegin {} Shape "curve" "point3 P" [-1 0 0  -.5 0 0  .5 0 0  1 0 0] "float width" .1
    Shape "curve" "point3 P" [-1 .177 -.177  -.5 .177 -.177  .5 .177 -.177  1 .177 -.177] "float width" {} AttributeEnd)",
                                                    motion, shadeWidth)));
    };
    const std::string moves = "ActiveTransform EndTime Translate 1e-5 0 0 ActiveTransform All";
    const glm::dvec3 lit = estimate(seen("", .03).image).mean;
    EXPECT_GT(lit.x, 0.1);
    expectRadiance(seen(moves, .03), lit, 1e-3);
    expectRadiance(seen("", .3), 0);
    expectRadiance(seen(moves, .3), 0);
}

/// A camera that turns by a quarter in front of a wall that is bright on one half, black on the other: it sees the middle at half of the
/// turn.
TEST(Motion, CamerasTurn) {
    View v = view("TransformTimes 0 1");
    v.lookAt = "0 0 0  1 0 1  0 1 0 ActiveTransform EndTime Rotate 90 0 1 0 ActiveTransform All";
    const Rendered r = render(sceneText(v, R"(LightSource "infinite" "rgb L" [1 1 1] Material "diffuse" "rgb reflectance" [0 0 0]
Shape "bilinearmesh" "point3 P" [0 -99 9  99 -99 9  0 99 9  99 99 9])"));
    expectRadiance(r, 0.5);
}

}  // namespace
}  // namespace eikonal
