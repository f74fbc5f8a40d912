// Regularization: what it does to paths with a nonspecular vertex, and that it does nothing to the others.

#include "rendering.h"

#include <fmt/format.h>

namespace eikonal {
namespace {

/// A floor point is looked at; above it hangs a ball of `material`, beside it stands a slab of it, neither in view. The ball is between the
/// point and a point light, so that what arrives of it without a detour over the floor comes off or through the two: nothing, if they were
/// sharp.
Rendered lightOnTheFloor(const std::string& integrator, const std::string& material) {
    View view;
    view.lookAt = "0 1 -2  0 0 0  0 1 0";
    view.more = "Integrator \"path\" \"integer maxdepth\" 4 " + integrator;
    return render(sceneText(view,
                            "LightSource \"point\" \"rgb I\" [9 9 9] \"point3 from\" [0 2.5 0]\n"
                            "Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5] AttributeBegin Rotate -90 1 0 0 Shape \"disk\" \"float "
                            "radius\" 9 AttributeEnd\n"
                            "Material " +
                                material +
                                " AttributeBegin Translate 0 1.2 0 Shape \"sphere\" \"float radius\" .4 AttributeEnd\n"
                                "AttributeBegin Translate 1 1 0 Rotate 70 0 1 0 Shape \"disk\" \"float radius\" 1.5 AttributeEnd"),
                  surfaces());
}

/// After the floor every path has a nonspecular vertex: a material is what it would be with pbrt-v4's wider microfacets (twice as wide, at
/// least 0.1, at most 0.3).
TEST(Regularize, IsTheRougherMaterialAfterABlurredBounce) {
    for (const char* material :
         {"\"conductor\" \"bool remaproughness\" false \"float roughness\" {}",
          "\"dielectric\" \"bool remaproughness\" false \"float roughness\" {}",
          "\"coateddiffuse\" \"bool remaproughness\" false \"float roughness\" {}",
          "\"coatedconductor\" \"bool remaproughness\" false \"float interface.roughness\" {0} \"float conductor.roughness\" {0}"})
        for (const auto& [given, becomes] : {std::pair{0., .1}, {.12, .24}}) {
            SCOPED_TRACE(fmt::format("{} of width {}", material, given));
            expectEqualMeans(lightOnTheFloor("\"bool regularize\" true", fmt::format(fmt::runtime(material), given)),
                             lightOnTheFloor("", fmt::format(fmt::runtime(material), becomes)), 0.1);
        }
}

/// A point light in a mirror cannot be found by paths; a mirror that the camera sees, also in another, stays one: bit by bit the same
/// image.
TEST(Regularize, LeavesAloneWhatIsSeenSharp) {
    const std::string mirrors =
        "LightSource \"infinite\" \"rgb L\" [.1 .5 .2] LightSource \"point\" \"rgb I\" [3 3 3] \"point3 from\" [0 0 -3]\n"
        "Material \"conductor\" \"float roughness\" 0 Shape \"bilinearmesh\" \"point3 P\" [-1 -1 0  1 -1 0  -1 1 0  1 1 0]\n"
        "Material \"dielectric\" \"float roughness\" 0 Translate .3 0 -6 Shape \"sphere\" \"float radius\" .5";
    const auto seen = [&](const std::string& more) {
        View view;
        view.fov = 20;
        view.more = "Integrator \"path\" \"integer maxdepth\" 6 " + more;
        return render(sceneText(view, mirrors), surfaces()).image;
    };
    expectSameBits(seen(""), seen("\"bool regularize\" true"), "mirrors and glass");
}

}  // namespace
}  // namespace eikonal
