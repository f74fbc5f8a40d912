// What `eikonal trade` tries on a scene, and what it measures errors against.

#include "app/trade/setting.h"

#include "app/trade/setting_renderer.h"
#include "cli.h"
#include "render/session.h"

#include <gmock/gmock.h>

namespace eikonal {
namespace {

using testing::Contains;
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
        for (const Setting& s : settingsFor(session, 1, false)) {
            names.push_back(s.name());
            if (s.isBiased) biased.push_back(s.name());
        }
        reference = referenceOptions(session);
    }
    std::vector<std::string> names, biased, reference;
};

/// A point light behind glass: paths from the camera never find it, so an image without light paths is not what the reference shows.
TEST_F(TradeSettings, FollowLightWherePathsFromTheCameraMissIt) {
    write("tiny.pbrt", tinyScene("Integrator \"path\" \"integer maxdepth\" 6",
                                 "LightSource \"point\" \"point3 from\" [0 3 0] Material \"dielectric\" Shape \"sphere\""));
    look({});
    for (const char* kind : {"bdpt", "vcm", "sppm"}) EXPECT_THAT(names, Contains(std::string("integrator: ") + kind));
    EXPECT_THAT(names, Not(Contains("integrator: volpath")));
    EXPECT_THAT(reference, Contains("--integrator=bdpt"));
    EXPECT_THAT(biased, Contains("as given"));
    EXPECT_THAT(biased, Contains("integrator: vcm"));

    look({"--integrator=vcm", "--color=spectral"});
    EXPECT_THAT(names, Contains("integrator: volpath"));
    EXPECT_THAT(names, Contains("integrator: bdpt"));
    EXPECT_THAT(names, Not(Contains("integrator: vcm")));
    EXPECT_THAT(reference, Contains("--integrator=bdpt"));
    EXPECT_THAT(biased, Not(Contains("integrator: bdpt")));
    EXPECT_THAT(biased, Contains("integrator: volpath"));
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
