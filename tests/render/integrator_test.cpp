// Integrators other than path tracing: values that can be derived, and what must be the same image.

#include "rendering.h"

#include <fmt/format.h>

#include <cmath>

namespace eikonal {
namespace {

/// `integrator`: what follows the directive.
View view(const std::string& integrator) {
    View v;
    v.more = "Integrator " + integrator;
    return v;
}
RenderSetup with(Feature feature) {
    RenderSetup setup = surfaces();
    setup.forced.require(feature);
    return setup;
}

/// A rectangle across the z axis, or beside it.
std::string across(double z, double size = 1000) {
    return fmt::format("Shape \"bilinearmesh\" \"point3 P\" [{0} {0} {2}  {1} {0} {2}  {0} {1} {2}  {1} {1} {2}]\n", -size, size, z);
}

// ---- ambient occlusion --------------------------------------------------------------------------------------------------

Rendered renderOcclusion(const std::string& parameters, const std::string& world) {
    return render(sceneText(view("\"ambientocclusion\" " + parameters), world), with(Feature::AMBIENT_OCCLUSION));
}

/// Nothing is in the way of a plane. With directions by the cosine there is no noise either. What the plane is made of, what it emits and which lights there
/// are does not matter.
TEST(AmbientOcclusion, APlaneUnderTheSkyIsOpen) {
    for (const std::string material : {"Material \"diffuse\" \"rgb reflectance\" [.1 .2 .3]\n", "Material \"conductor\" AreaLightSource \"diffuse\" LightSource \"point\"\n"}) {
        const Rendered r = renderOcclusion("", material + across(0));
        expectRadiance(r, 1, 1e-6);
    }
    expectRadiance(renderOcclusion("\"bool cossample\" false", across(0)), 1);
}

/// A wall beside the point, one unit away and sqrt(3) high, hides what is less than 60 degrees above the plane on its side: by the form factor of a strip,
/// (1 - cos 60) / 2 of the light. Of a wall without end, what is less than 2 away is in directions within 60 degrees of the wall's normal: by
/// Nusselt's analogue a segment of the unit disk, (acos(1/2) - sqrt(3)/4) / pi.
TEST(AmbientOcclusion, AWallHidesItsFormFactor) {
    const auto wall = [](double height) {
        return across(0) + fmt::format("Shape \"bilinearmesh\" \"point3 P\" [1 -1000 {0}  1 1000 {0}  1 -1000 0  1 1000 0]\n", -height);
    };
    const double segment = (std::acos(0.5) - std::sqrt(3) / 4) / M_PI;
    for (const char* sampling : {"\"bool cossample\" true ", "\"bool cossample\" false "}) {
        expectRadiance(renderOcclusion(sampling, wall(std::sqrt(3))), 0.75);
        expectRadiance(renderOcclusion(std::string(sampling) + "\"float maxdistance\" 2", wall(1000)), 1 - segment);
        expectRadiance(renderOcclusion(std::string(sampling) + "\"float maxdistance\" .99", wall(1000)), 1);
    }
}

/// Where nothing is seen there is no light.
TEST(AmbientOcclusion, OnlySurfacesAreSeen) {
    expectRadiance(renderOcclusion("", "Shape \"sphere\" \"float radius\" .1"), 1, 1e-6);
    expectRadiance(renderOcclusion("", "Translate 0 5 0 Shape \"sphere\""), 0);
}

// ---- variants of path tracing -------------------------------------------------------------------------------------------

constexpr const char* room = R"(LightSource "infinite" "rgb L" [.3 .4 .5]
AttributeBegin AreaLightSource "diffuse" "rgb L" [4 3 2] Translate 0 2 -2 Rotate 60 1 0 0 Shape "disk" "float radius" 1.5 AttributeEnd
AttributeBegin Material "conductor" "float roughness" .4 Translate 1.5 0 -1 Shape "sphere" AttributeEnd
Material "diffuse" "rgb reflectance" [.6 .5 .4]
)";

/// One scattering event, as of "path" with a depth of 1: bit by bit; and whatever depth it is given.
TEST(Direct, IsAPathOfDepthOne) {
    const auto image = [](const std::string& integrator) { return render(sceneText(view(integrator), room + across(0)), surfaces()).image; };
    const FilmImage path = image("\"path\" \"integer maxdepth\" 1");
    expectSameBits(path, image("\"direct\""), "direct");
    expectSameBits(path, image("\"direct\" \"integer maxdepth\" 7"), "direct with a depth");
    EXPECT_LT(estimate(path).mean.x, estimate(image("\"path\"")).mean.x);
}

/// Worse means, the same end.
TEST(SimplePath, HasTheExpectationOfPath) {
    const auto rendered = [](const std::string& integrator, const RenderSetup& setup = surfaces()) { return render(sceneText(view(integrator), room + across(0)), setup); };
    const Rendered path = rendered("\"path\" \"integer maxdepth\" 3");
    expectEqualMeans(path, rendered("\"simplepath\" \"integer maxdepth\" 3 \"bool samplelights\" false"), 0.02);
    expectEqualMeans(path, rendered("\"simplepath\" \"integer maxdepth\" 3 \"bool samplebsdf\" false", with(Feature::UNIFORM_DIRECTIONS)), 0.02);
    expectEqualMeans(path, rendered("\"randomwalk\" \"integer maxdepth\" 3", with(Feature::UNIFORM_DIRECTIONS)), 0.02);
}

/// No path meets a point.
TEST(SimplePath, FindsNoPointByChance) {
    const std::string world = "LightSource \"point\" \"point3 from\" [0 0 -2]\n" + across(0);
    expectRadiance(render(sceneText(view("\"simplepath\" \"bool samplelights\" false"), world), surfaces()), 0);
    expectRadiance(render(sceneText(view("\"randomwalk\""), world), with(Feature::UNIFORM_DIRECTIONS)), 0);
}

}  // namespace
}  // namespace eikonal
