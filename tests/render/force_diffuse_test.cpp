// Option "forcediffuse": every surface scatters as a diffuse one that reflects as much.

#include "rendering.h"

#include <fmt/format.h>

namespace eikonal {
namespace {

/// A wall whose outside a camera looks at head on or, with `tilt`, at that angle; all around it is light of radiance 1.
std::string wall(const std::string& material, double tilt = 0) {
    View view;
    view.maxDepth = 1;
    return "Option \"forcediffuse\" true " +
           sceneText(view, fmt::format("LightSource \"infinite\" \"rgb L\" [1 1 1] Material {} Rotate {} 0 1 0 "
                                       "Shape \"disk\" \"float radius\" 9",
                                       material, 180 + tilt));
}

/// Reflectance of a dielectric boundary for unpolarized light.
double fresnel(double cosine, double eta) {
    const double inside = std::sqrt(1 - (1 - cosine * cosine) / (eta * eta));
    const double parallel = (eta * cosine - inside) / (eta * cosine + inside), across = (cosine - eta * inside) / (cosine + eta * inside);
    return (parallel * parallel + across * across) / 2;
}

/// A surface in a furnace shows its reflectance, to which what is transmitted counts: radiance that enters glass is squeezed.
TEST(ForceDiffuse, ReflectsWhatTheMaterialScatters) {
    expectRadiance(render(wall("\"thindielectric\"")), 1);
    expectRadiance(render(wall("\"diffusetransmission\" \"rgb reflectance\" [.3 .2 .1] \"rgb transmittance\" [.2 .4 .1]")),
                   {.5, .6, .2});
    expectRadiance(render(wall("\"hair\" \"rgb sigma_a\" [0 0 0]")), 1, 0.02);
    for (const double tilt : {0., 60.}) {
        const double reflected = fresnel(std::cos(tilt * M_PI / 180), 1.5);
        expectRadiance(render(wall("\"dielectric\" \"float eta\" 1.5", tilt)), reflected + (1 - reflected) / (1.5 * 1.5));
    }
}

/// Light that a mirror does not send to the camera, a diffuse wall does: under a point light, reflectance / pi times the irradiance.
TEST(ForceDiffuse, SpreadsWhatAMirrorReflects) {
    View view;
    view.maxDepth = 1;
    const std::string lit = sceneText(view, "LightSource \"point\" \"rgb I\" [9 9 9] \"point3 from\" [0 4 -3]\n"
                                            "Material \"conductor\" \"float roughness\" 0 \"rgb reflectance\" [.9 .5 .2]\n"
                                            "Shape \"disk\" \"float radius\" 9");
    expectRadiance(render(lit), 0);
    const double irradiance = 9 * (3. / 5) / 25;
    expectRadiance(render("Option \"forcediffuse\" true " + lit), glm::dvec3(.9, .5, .2) * (irradiance / M_PI));
}

/// Nothing enters a body: a point behind glass or in skin is dark.
TEST(ForceDiffuse, LetsNothingThrough) {
    for (const char* material : {"\"dielectric\"", "\"thindielectric\"", "\"subsurface\" \"string method\" \"randomwalk\"",
                                 "\"diffusetransmission\""}) {
        View view;
        const std::string text = sceneText(view, fmt::format("Material \"diffuse\" AttributeBegin Translate 0 0 -3 AreaLightSource "
                                                             "\"diffuse\" \"rgb L\" [1 1 1] Shape \"sphere\" \"float radius\" .1 "
                                                             "AttributeEnd Translate 0 0 -3 Material {} Shape \"sphere\" \"float "
                                                             "radius\" .2", material));
        expectRadiance(render("Option \"forcediffuse\" true " + text), 0);
    }
}

TEST(ForceDiffuse, LeavesDiffuseSurfacesAsTheyAre) {
    const Estimate forced = estimate(render(wall("\"diffuse\" \"rgb reflectance\" [.3 .5 .7]", 30)).image);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(forced.mean[c], glm::dvec3(.3, .5, .7)[c], 1e-6);
}

}  // namespace
}  // namespace eikonal
