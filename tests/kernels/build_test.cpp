// Every stage builds without a warning, whatever a scene requires: nothing, everything, or one feature alone.

#include "stage.h"

#include <gtest/gtest.h>

namespace eikonal {
namespace {

/// The stage's kernel builds; nothing is launched, and nothing is kept.
void expectBuilds(const std::string& stage, Features features, const std::string& what) {
    const StageProgram& program = stageProgram(stage);
    /* A stage is only built for a scene that has what it is for */
    if (program.row->requirement.feature() != Feature::none) features.require(program.row->requirement.feature());
    for (int environments : {0, 2}) {
        if (!program.row->requirement.isMet(features, {.environments = environments})) continue;
        const BuildSettings settings = shippedSettings(features, {.environments = environments});
        try { testCompiler().build(program.text, program.row->name, settings);
        } catch (const std::exception& error) {
            ADD_FAILURE() << stage << " with " << what << " and " << environments
                          << " environments: " << std::string(error.what()).substr(0, 1500);
        }
        if (what != "all features") break;
    }
}

class Builds : public testing::TestWithParam<std::string> {};

TEST_P(Builds, WithNothingAndWithEverything) {
    expectBuilds(GetParam(), Features(), "no feature");
    expectBuilds(GetParam(), Features::all(), "all features");
    expectBuilds(GetParam(), Features::allSpectral(), "all features at wavelengths");
    expectBuilds(GetParam(), Features::everything(), "all features with a film that keeps a spectrum");
}

class SlowBuilds : public testing::TestWithParam<std::string> {};

TEST_P(SlowBuilds, WithEachFeatureAlone) {
    for (size_t f = 0; f < featureCount(); ++f)
        expectBuilds(GetParam(), Features().require(static_cast<Feature>(f)), featureName(static_cast<Feature>(f)));
}

/// A program with its own poison of new items builds too: what the stage tests run.
TEST(BuildsPoisoned, EveryStageWithEverything) {
    for (const std::string& stage : allStages()) {
        const StageProgram& program = stageProgram(stage);
        BuildSettings settings = shippedSettings(Features::all());
        settings.poison = true;
        EXPECT_NO_THROW(testCompiler().build(program.text, program.row->name, settings)) << stage;
    }
}

std::string nameOf(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    for (char& c : name) if (c == ' ') c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Stages, Builds, testing::ValuesIn(allStages()), nameOf);
INSTANTIATE_TEST_SUITE_P(Slow, SlowBuilds, testing::ValuesIn(allStages()), nameOf);

}  // namespace
}  // namespace eikonal
