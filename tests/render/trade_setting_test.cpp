// What `eikonal trade` tries on a scene, and what it measures errors against.

#include "app/trade/setting.h"

#include "app/trade/followed_light.h"
#include "app/trade/setting_renderer.h"
#include "cli.h"
#include "render/session.h"

#include <gmock/gmock.h>

namespace eikonal {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;

class TradeSettings : public Cli {
protected:
    /// The settings for tiny.pbrt, and the options of its reference.
    void look(const std::vector<std::string>& options) {
        Diagnostics diagnostics;
        const Options parsed = renderOptions(path("tiny.pbrt"), options);
        Session session(parsed, diagnostics);
        session.load(false);
        session.pack({});
        names.clear();
        biased.clear();
        const IntegratorKind* const follower = followerOf(session, path("tiny.pbrt"), options);
        for (const Setting& s : settingsFor(session, 1, false, follower)) {
            names.push_back(s.name());
            if (s.isBiased) biased.push_back(s.name());
        }
        reference = referenceOptions(session, follower);
    }
    std::vector<std::string> names, biased, reference;
};

const char* const glassUnderAPoint = "LightSource \"point\" \"point3 from\" [0 3 0] Material \"dielectric\" Shape \"sphere\"";
const char* const glassUnderALamp =
    "Material \"dielectric\" Shape \"sphere\" AttributeBegin AreaLightSource \"diffuse\" Material \"diffuse\" Translate 0 3 0 "
    "Shape \"sphere\" \"float radius\" .001 AttributeEnd";

/// A lamp behind glass: paths from the camera hardly find it.
TEST_F(TradeSettings, FollowLightWherePathsFromTheCameraHardlyFindIt) {
    write("tiny.pbrt", std::string("Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 8 LookAt 0 1 -4  0 0 0  0 1 0 "
                                   "Camera \"perspective\" Integrator \"path\" \"integer maxdepth\" 6 WorldBegin ") +
                           glassUnderALamp);
    look({"--color=spectral"});
    for (const char* kind : {"bdpt", "vcm", "sppm"}) EXPECT_THAT(names, Contains(std::string("integrator: ") + kind));
    EXPECT_THAT(names, Not(Contains("integrator: volpath")));
    EXPECT_THAT(reference, ElementsAre("--integrator=bdpt"));
    EXPECT_THAT(biased, Contains("as given"));
    EXPECT_THAT(biased, Contains("integrator: vcm"));
    EXPECT_THAT(biased, Not(Contains("integrator: bdpt")));

    look({"--integrator=vcm", "--color=spectral"});
    EXPECT_THAT(names, Contains("integrator: volpath"));
    EXPECT_THAT(names, Contains("integrator: bdpt"));
    EXPECT_THAT(names, Not(Contains("integrator: vcm")));
    EXPECT_THAT(names, Not(Contains("path guiding: on")));
    EXPECT_THAT(reference, ElementsAre("--integrator=bdpt"));
    EXPECT_THAT(biased, Contains("as given"));
    EXPECT_THAT(biased, Not(Contains("integrator: bdpt")));
    EXPECT_THAT(biased, Contains("integrator: volpath"));
}

/// What a point light sends through glass, seen through glass, only merging finds.
TEST_F(TradeSettings, MergeWhereNothingElseFindsTheLight) {
    write("tiny.pbrt", tinyScene("Integrator \"bdpt\" \"integer maxdepth\" 6", glassUnderAPoint));
    look({"--color=spectral"});
    EXPECT_THAT(reference, ElementsAre("--integrator=vcm"));
    EXPECT_THAT(biased, Contains("as given"));
}

/// Where light paths would not find it, where they cannot be traced, and where the user wants a part of light transport only.
TEST_F(TradeSettings, FollowNoLightWhereThatIsNotTheImage) {
    const std::string body = "LightSource \"point\" Material \"subsurface\" Translate 3 0 0 Shape \"sphere\"";
    const std::string fog = "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" AttributeBegin Material \"interface\" MediumInterface "
                            "\"fog\" \"\" Translate 3 0 0 Shape \"sphere\" AttributeEnd ";
    for (const auto& [integrator, world] :
         {std::pair("path", body), {"direct", std::string(glassUnderAPoint)}, {"path", fog + glassUnderAPoint}}) {
        write("tiny.pbrt", tinyScene(std::string("Integrator \"") + integrator + "\"", world));
        look({});
        EXPECT_THAT(names, Not(Contains("integrator: bdpt"))) << world;
        for (const std::string& option : reference) EXPECT_THAT(option, Not(testing::StartsWith("--integrator"))) << world;
    }
}

TEST_F(TradeSettings, FollowNoLightWhereNoneIsHidden) {
    write("tiny.pbrt", tinyScene("Integrator \"path\" \"integer maxdepth\" 6", "LightSource \"infinite\" Shape \"sphere\""));
    look({"--color=spectral"});
    EXPECT_THAT(names, Not(Contains("integrator: bdpt")));
    EXPECT_THAT(names, Contains("path guiding: on"));
    EXPECT_THAT(reference, testing::IsEmpty());
    EXPECT_THAT(biased, Not(Contains("as given")));
}

/// What they say must be options that the program takes.
TEST_F(TradeSettings, ReferencesHaveOptionsThatTheProgramTakes) {
    look({"--fireflies=reweight", "--max-component-value=2", "--regularize=on"});
    for (const char* option : {"--fireflies=keep", "--max-component-value=0", "--regularize=off"}) EXPECT_THAT(reference, Contains(option));
    EXPECT_NO_THROW(renderOptions(path("tiny.pbrt"), reference));
}

}  // namespace
}  // namespace eikonal
