// Shapes at the extremes.

#include "rendering.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace eikonal {
namespace {

// White bodies that touch under a white sky cannot be seen: every path leaves in the end with all of its light. Where the gap between
// them is narrower than the rounding of points, a ray that leaves one may start in the other, where it is lost. The origin of scene space
// is near the ball, so on the larger body, of size 1, points at a distance x from the contact are rounded by about 1e-6 r, and the gap is
// x^2 / 2r: narrower than that up to x = 1.4e-3 r, whatever r.
TEST(ExtremeShapes, BallsThatTouchCannotBeSeen) {
    const std::vector<std::string> large{R"(Translate 0 -1 0 Shape "sphere" "float radius" 1)",
                                         R"(Translate 0 -1 0 Scale 1 1 -1 Rotate -90 1 0 0
                                             Shape "sphere" "float zmin" 0 "float phimax" 300)",
                                         R"(Material "dielectric" Translate 0 -1 0 Shape "sphere")",
                                         R"(Translate 0 -3 0 Rotate 20 0 1 0 Scale 2 3 1 Shape "sphere" "float radius" 1)",
                                         R"(Translate 0 -1 0 Shape "cylinder" "float radius" 1)",
                                         R"(Rotate -90 1 0 0 Translate -0.9 0 0 Shape "disk" "float radius" 1)"};
    for (const std::string& body : large)
        for (double r : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8}) {
            View view;
            view.lookAt = fmt::format("0 {} {}  0 {} 0  0 1 0 Rotate -33 1 2 3", 3 * r, -6 * r, r);
            view.fov = 40;
            view.samples = 16;
            view.maxDepth = 200;
            const Rendered seen = render(
                sceneText(view, fmt::format(R"(LightSource "infinite" "rgb L" [1 1 1] Material "diffuse" "rgb reflectance" [1 1 1]
                    Rotate 33 1 2 3
                    AttributeBegin {1} AttributeEnd
                    Translate 0 {0} 0 Shape "sphere" "float radius" {0})", r, body)), surfaces());
            for (const glm::vec3& c : seen.image.color) EXPECT_NEAR(c.g, 1, 1e-4) << r << " " << body;
        }
}

}  // namespace
}  // namespace eikonal
