// Shapes at the extremes.

#include "rendering.h"

#include <fmt/format.h>

namespace eikonal {
namespace {

// White balls that touch under a white sky cannot be seen: every path leaves in the end with all of its light. Near the contact the gap is
// narrower than the rounding of points, and a ray that leaves one ball may start in the other, where it is lost. Points are rounded by
// about 4e-7 of the larger radius R, and the gap at a distance x is x^2 / 2r: narrower up to x = 9e-4 sqrt(r R), 3 % of r at 1,000:1.
TEST(ExtremeShapes, BallsThatTouchCannotBeSeen) {
    for (double r : {1e-1, 1e-2, 1e-3}) {
        View view;
        view.lookAt = fmt::format("0 {} {}  0 {} 0  0 1 0", 3 * r, -6 * r, r);
        view.fov = 40;
        view.samples = 16;
        view.maxDepth = 200;
        const Rendered seen = render(
            sceneText(view, fmt::format(R"(LightSource "infinite" "rgb L" [1 1 1] Material "diffuse" "rgb reflectance" [1 1 1]
                AttributeBegin Translate 0 -1 0 Shape "sphere" "float radius" 1 AttributeEnd
                Translate 0 {0} 0 Shape "sphere" "float radius" {0})", r)), surfaces());
        for (const glm::vec3& c : seen.image.color) EXPECT_NEAR(c.g, 1, 1e-4) << r;
    }
}

}  // namespace
}  // namespace eikonal
