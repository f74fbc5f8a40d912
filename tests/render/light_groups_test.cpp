// Light groups: each holds the light of its lights, and they sum to the image.

#include "both_ends.h"
#include "cli.h"

#include "image/image_file.h"

#include <gmock/gmock.h>

#include <cmath>
#include <regex>

namespace eikonal {
namespace {

const std::string key = "LightSource \"point\" \"rgb I\" [2 1.5 1] \"point3 from\" [.5 1.6 -.5] \"string lightgroup\" \"key\"\n";
const std::string fill = R"(AttributeBegin AreaLightSource "diffuse" "rgb L" [3 3 4] "string lightgroup" "fill" Translate -.6 1.4 0
    Shape "sphere" "float radius" .1 AttributeEnd
    LightSource "infinite" "rgb L" [.1 .2 .1] "string lightgroup" "fill"
)";
const std::string rest = "LightSource \"infinite\" \"rgb L\" [.3 .4 .5]\n" + panel;
const std::string smoke = R"(MakeNamedMedium "smoke" "string type" "homogeneous" "rgb sigma_a" [.1 .2 .3] "rgb sigma_s" [3 2 1]
        "rgb Le" [.1 .1 .1]
    AttributeBegin Material "interface" Translate 0 .9 -.4 MediumInterface "smoke" "" Shape "sphere" "float radius" .5 AttributeEnd
)";

Rendered renderGroups(const std::string& text, const RenderSetup& setup = {}) {
    PackedScene scene = packScene(text);
    scene.require(Feature::LIGHT_GROUPS, "the test");
    scene.constants.lightGroups = static_cast<int>(scene.lightGroups.size());
    return render(std::move(scene), setup);
}

glm::dvec3 meanOfLayer(const std::vector<glm::vec3>& layer) {
    glm::dvec3 sum(0);
    for (const glm::vec3& c : layer) sum += glm::dvec3(c);
    return sum / static_cast<double>(layer.size());
}

struct Case { std::string name, directive, world; };
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
class LightGroups : public testing::TestWithParam<Case> {
protected:
    std::string text(const std::string& lights, int samples) const {
        View v = view();
        v.width = v.height = 16;
        v.samples = samples;
        return sceneWith(v, GetParam().directive, room + lights + GetParam().world);
    }
};

TEST_P(LightGroups, SumToTheImageAndKeepItsBits) {
    RenderSetup setup;
    setup.contraction = false;
    const std::string scene = text(key + fill + rest, 32);
    const Rendered with = renderGroups(scene, setup);
    ASSERT_EQ(with.image.lightGroups.size(), 3u);
    size_t wrong = 0;
    for (size_t i = 0; i < with.image.pixelCount(); ++i) {
        glm::dvec3 sum(0), size(0);
        for (const LightGroup& group : with.image.lightGroups) {
            sum += glm::dvec3(group.color[i]);
            size += glm::abs(glm::dvec3(group.color[i]));
        }
        for (int c = 0; c < 3; ++c) wrong += !(std::abs(sum[c] - static_cast<double>(with.image.color[i][c])) <= 3e-6 * size[c]);
    }
    EXPECT_EQ(wrong, 0u) << "values that are not the sum of the groups";
    expectSameBits(with.image, render(scene, setup).image, "without groups");
    setup.shape.wavePaths = 1000;
    setup.splits = {24};
    expectSameBits(with.image, renderGroups(scene, setup).image, "in small waves and two ranges of samples");
}

/// The lights without their light: what has a shape still blocks and reflects that of others.
std::string shapesOf(const std::string& lights) {
    const std::regex directive("(AreaLightSource|LightSource) \"[a-z]+\"( *\"[a-z]+ [A-Za-z]+\" (\\[[^\\]]*\\]|\"[a-z]+\"))*");
    return std::regex_replace(lights, directive, "");
}

/// The image of a scene in which the lights of one group only shine has the light of that group.
TEST_P(LightGroups, HoldTheLightOfTheirLights) {
    const Rendered all = renderGroups(text(key + fill + rest, 256));
    for (const LightGroup& group : all.image.lightGroups) {
        const std::string lights = group.name == "key"    ? key + shapesOf(fill + rest)
                                   : group.name == "fill" ? fill + shapesOf(rest)
                                                          : rest + shapesOf(fill);
        /* What a medium emits is of the default group */
        std::string alone = text(lights, 256);
        if (const size_t glow = alone.find("\"rgb Le\" [.1 .1 .1]"); glow != alone.npos && group.name != "default")
            alone.erase(glow, 20);
        const glm::dvec3 expected = meanOfLayer(render(alone).image.color), found = meanOfLayer(group.color);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], .03 * expected[c]) << group.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Of, LightGroups,
                         testing::Values(Case{"paths", "", ball("\"dielectric\"")},
                                         Case{"media_and_wavelengths",
                                              "Film \"spectral\" \"integer xresolution\" 16 \"integer yresolution\" 16", smoke},
                                         Case{"a_tree_of_lights",
                                              "Integrator \"volpath\" \"integer maxdepth\" 6 \"string lightsampler\" \"bvh\"",
                                              ball("\"conductor\"")},
                                         Case{"a_tree_of_rays", "Integrator \"whitted\"", ball("\"dielectric\"")}),
                         [](const auto& info) { return info.param.name; });

/// By name: in an EXR, as layers. What cannot be told apart is refused.
class CliLightGroups : public Cli {};
TEST_F(CliLightGroups, AreLayersOfAnExr) {
    View v = view();
    v.samples = 2;
    write("lights.pbrt", sceneText(v, room + key + fill));
    const Outcome run = this->run({"render", "lights.pbrt", "-o", "a.exr", "--aov", "lightgroups"});
    ASSERT_EQ(run.status, 0) << run.error;
    std::vector<std::string> names;
    for (const LightGroup& group : readImage(path("a.exr")).image.lightGroups) names.push_back(group.name);
    EXPECT_THAT(names, testing::UnorderedElementsAre("default", "key", "fill"));
    const Outcome both = this->run({"render", "lights.pbrt", "-o", "b.exr", "--aov", "lightgroups", "--integrator", "bdpt"});
    EXPECT_EQ(both.status, 2);
    EXPECT_THAT(both.error, testing::HasSubstr("add --integrator volpath"));
    write("wrong.pbrt", sceneText(v, "LightSource \"point\" \"string lightgroup\" \"a.b\""));
    EXPECT_THAT(this->run({"render", "wrong.pbrt"}).error, testing::HasSubstr("letters, digits, _ and - only"));
}

}  // namespace
}  // namespace eikonal
