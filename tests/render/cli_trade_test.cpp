// `eikonal trade`: the page that compares settings, and going on after an interruption.

#include "cli.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <csignal>

#include <unistd.h>

namespace eikonal {
namespace {

using testing::HasSubstr;
using testing::Not;

nlohmann::json jsonIn(const std::string& text) { return nlohmann::json::parse(text); }

TEST_F(Cli, TradeMeasuresSettingsAndRecommendsSome) {
    const std::vector<std::string> command{"trade", "tiny.pbrt", "--budget", "25s", "--for", "1s", "--for", "10%", "-o", "page.html"};
    const Outcome run = this->run(command);
    ASSERT_EQ(run.status, 0) << run.error;
    EXPECT_LT(run.seconds, 60);
    EXPECT_THAT(run.out, HasSubstr("wrote page.html, page.csv and page.json"));
    EXPECT_THAT(run.out, HasSubstr("for 10 %: eikonal render tiny.pbrt"));

    /* The page needs nothing from elsewhere */
    const std::string page = read(path("page.html"));
    for (const char* outside : {"http:", "https:", "//cdn", "<script", "<link", "url("}) EXPECT_THAT(page, Not(HasSubstr(outside)));
    EXPECT_THAT(page, HasSubstr("src=\"data:image/png;base64,"));
    EXPECT_THAT(page, HasSubstr("<svg"));

    const nlohmann::json json = jsonIn(read(path("page.json")));
    EXPECT_LT(json["reference"]["relativeError"], 0.05);
    int own = 0;  // how many rungs fit into the budget, and with how many seeds, depends on the machine and its other work
    for (const auto& point : json["points"]) {
        EXPECT_GT(point["samples"], 0);
        EXPECT_LE(point["relativeMse"]["low"], point["relativeMse"]["value"]);
        own += point["setting"] == "as given" && point["seeds"] >= 4;
    }
    for (const auto& point : jsonIn(read(path("page.study/study.json")))["points"])
        for (size_t i = 0; i < point["seeds"].size(); ++i) EXPECT_EQ(point["seeds"][i]["seed"], i + 1) << point["setting"];
    EXPECT_GE(own, 1) << "rungs of the options as given";
    EXPECT_EQ(json["recommendations"].size(), 2u);
    const std::string csv = read(path("page.csv"));
    EXPECT_EQ(static_cast<size_t>(std::count(csv.begin(), csv.end(), '\n')), 1 + json["points"].size());

    /* The budget is that of all runs: the same command has little left to do */
    const Outcome again = this->run(command);
    EXPECT_EQ(again.status, 0) << again.error;
    EXPECT_LT(again.seconds, run.seconds);
    EXPECT_GE(jsonIn(read(path("page.json")))["points"].size(), json["points"].size());

    /* But not for another scene under the same name */
    write("tiny.pbrt", tinyScene("", "LightSource \"point\" \"rgb I\" [1 2 3]"));
    EXPECT_THAT(this->run(command).error, HasSubstr("content has changed"));
}

TEST_F(Cli, TradeGoesOnAfterAnInterruption) {
    const std::vector<std::string> command{"trade", "tiny.pbrt", "--budget", "1h", "-o", "page.html"};
    const Running running = start(command);
    for (int i = 0; i < 600 && !exists("page.study/points/0-16-4.first.exr"); ++i) ::usleep(100'000);
    ::kill(running.process, SIGINT);
    const Outcome run = wait(running);
    EXPECT_EQ(run.status, 128 + SIGINT);
    EXPECT_THAT(run.error, HasSubstr("the same command goes on where it was"));
    const nlohmann::json before = jsonIn(read(path("page.study/study.json")));
    EXPECT_TRUE(exists("page.html"));

    const Running further = start(command);
    for (int i = 0; i < 300 && jsonIn(read(path("page.study/study.json")))["spentSeconds"] <= before["spentSeconds"]; ++i)
        ::usleep(100'000);
    ::kill(further.process, SIGINT);
    EXPECT_EQ(wait(further).status, 128 + SIGINT);
    const nlohmann::json after = jsonIn(read(path("page.study/study.json")));
    ASSERT_GE(after["points"].size(), before["points"].size());
    EXPECT_EQ(after["points"][0]["seeds"][0], before["points"][0]["seeds"][0]);
    EXPECT_GT(after["spentSeconds"], before["spentSeconds"]);
}

TEST_F(Cli, TradeSaysWhatItCannotMeasure) {
    EXPECT_THAT(run({"trade", "tiny.pbrt", "-o", "page.png"}).error, HasSubstr("-o names a page, \"page.html\" for example"));
    EXPECT_THAT(run({"trade", "tiny.pbrt", "--cropwindow", "0,0.5,0,1"}).error, HasSubstr("trade measures whole images"));
    write("dark.pbrt", "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 8\nWorldBegin\nShape \"sphere\"\n");
    const Outcome dark = run({"trade", "dark.pbrt", "--budget", "10s"});
    EXPECT_EQ(dark.status, 1);
    EXPECT_THAT(dark.error, HasSubstr("is black"));
}

}  // namespace
}  // namespace eikonal
