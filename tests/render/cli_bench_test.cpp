// What `eikonal bench` measures.

#include "cli.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace eikonal {
namespace {

class Bench : public Cli {
protected:
    nlohmann::json bench(std::vector<std::string> options) {
        options.insert(options.begin(), {"bench", "tiny.pbrt", "--json", "bench.json"});
        const Outcome run = this->run(options);
        EXPECT_EQ(run.status, 0) << run.error;
        return nlohmann::json::parse(read(path("bench.json")));
    }
};

TEST_F(Bench, CountsRealRaysOnly) {
    const auto json = bench({"--repeats", "2"});
    EXPECT_FALSE(json.contains("efficiency"));
    EXPECT_EQ(json.at("paths"), 16 * 12 * 4);
    EXPECT_GE(json.at("rays"), 16 * 12 * 4) << "one from the camera for each path";
    EXPECT_LE(json.at("shadowRays"), json.at("rays"));
    EXPECT_GT(json.at("shadowRays"), 0);
    EXPECT_GT(json.at("raysPerSecond"), 0);
    for (const auto& stage : json.at("stages")) {
        EXPECT_GT(stage.at("seconds"), 0) << stage;
        EXPECT_GT(stage.at("occupancy"), 0) << stage;
        EXPECT_LE(stage.at("occupancy"), 1) << stage;
        EXPECT_EQ(stage.at("queueBytesPerSlot") > 0, stage.at("stage") != "resolve_film") << stage;
    }
    EXPECT_GT(json.at("queueCopyBytesPerSecond"), 1e8);
    /* 16 x 12 pixels are a tile of 16 x 16; every stage that runs over the rays' slots has their holes */
    const auto occupancy = [&](const std::string& name) {
        for (const auto& stage : json.at("stages")) if (stage.at("stage") == name) return stage.at("occupancy").get<double>();
        return -1.;
    };
    EXPECT_LT(occupancy("generate_rays"), 1);
    EXPECT_EQ(occupancy("resolve_film"), occupancy("generate_rays")) << "of the same tiles";
    EXPECT_EQ(occupancy("classify_intersections"), occupancy("intersect_rays"));
    EXPECT_EQ(occupancy("route_intersections"), occupancy("intersect_rays"));
}

// In a closed white ball, paths have all their events. The ray after the last one is for emitters and skies: without them it is not traced.
TEST_F(Bench, LastRaysAreTracedWhereTheyCanFindLight) {
    const auto raysOfPath = [&](const std::string& light) {
        write("ball.pbrt", R"(Integrator "path" "integer maxdepth" 3 Sampler "independent" "integer pixelsamples" 16
            Film "rgb" "string filename" "ball.exr" "integer xresolution" 16 "integer yresolution" 16
            Camera "perspective" WorldBegin )" + light + R"( Material "diffuse" "rgb reflectance" [1 1 1]
            Shape "sphere" "float radius" 2)");
        const Outcome run = this->run({"bench", "ball.pbrt", "--json", "bench.json", "--roulette-depth", "100"});
        EXPECT_EQ(run.status, 0) << run.error;
        const auto json = nlohmann::json::parse(read(path("bench.json")));
        return json.at("rays").get<double>() / json.at("paths").get<double>();
    };
    EXPECT_EQ(raysOfPath("LightSource \"point\""), 3);
    EXPECT_EQ(raysOfPath("LightSource \"infinite\""), 4);
    EXPECT_EQ(raysOfPath("AreaLightSource \"diffuse\" \"bool twosided\" true"), 4);
}

// Independent samples: four times as many have a quarter of the variance. 192 pixels and 8 seeds know each to about 6 %.
TEST_F(Bench, EfficiencyIsOfTheVarianceBetweenSeeds) {
    const auto few = bench({"--efficiency", "--repeats", "8", "--sampler", "independent", "--spp", "16"});
    const auto many = bench({"--efficiency", "--repeats", "8", "--sampler", "independent", "--spp", "64"});
    for (const auto& json : {few, many}) {
        EXPECT_TRUE(std::isfinite(json.at("efficiency").get<double>()));
        EXPECT_NEAR(
            json.at("efficiency").get<double>() * json.at("relativeVariance").get<double>() * json.at("renderSeconds").get<double>(), 1,
            1e-9);
        EXPECT_LT(json.at("efficiencyInterval")[0], json.at("efficiency"));
        EXPECT_GT(json.at("efficiencyInterval")[1], json.at("efficiency"));
    }
    const double ratio = many.at("relativeVariance").get<double>() / few.at("relativeVariance").get<double>();
    const auto relative = [](const nlohmann::json& json) {
        return json.at("relativeVarianceStandardError").get<double>() / json.at("relativeVariance").get<double>();
    };
    EXPECT_LT(relative(few), .15);
    EXPECT_NEAR(ratio, .25, 4 * ratio * std::hypot(relative(few), relative(many)));
}

}  // namespace
}  // namespace eikonal
