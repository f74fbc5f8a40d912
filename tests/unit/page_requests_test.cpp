// What the page of --view may ask for, and what is refused.

#include "view/page_requests.h"
#include "view/token.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>
#include <limits>

namespace eikonal {
namespace {

using testing::HasSubstr;

class Page : public testing::Test {
protected:
    HttpAnswer get(const std::string& path, std::map<std::string, std::string> parameters = {}) const {
        return requests.answer({.method = "GET", .path = path, .host = "127.0.0.1:8000", .parameters = std::move(parameters)});
    }
    HttpAnswer post(const std::string& body, const std::string& origin = "") const {
        return requests.answer({.method = "POST", .path = "/secret/wish", .host = "127.0.0.1:8000", .origin = origin, .body = body});
    }
    void showImage() {
        auto image = std::make_shared<FilmImage>(8, 6, PixelBounds{2, 5, 1, 3});
        image->color[0] = {1, 2, 3};
        image->depth.assign(6, 0.5f);
        image->depth[1] = std::numeric_limits<float>::infinity();
        render.showImage(image, {0.1, 0.05, 0.2, "few samples"}, 3);
    }

    LiveRender render;
    PageRequests requests{render, "secret", "127.0.0.1", {ToneCurve::filmic, 1.5}};
};

TEST_F(Page, NothingIsThereWithoutTheToken) {
    for (const char* path : {"", "/", "/state", "/secre/state", "/secret", "/secrets/state", "/SECRET/state", "//state",
                             "/secret/../etc/passwd", "secret/state", "/secret/page.html/", "/secret//state"})
        EXPECT_EQ(get(path).status, 404) << path;
    EXPECT_EQ(get("/secret/").status, 200);
    EXPECT_THAT(get("/secret/").body, HasSubstr("<!doctype html>"));
    EXPECT_THAT(get("/secret/page.js").type, HasSubstr("text/javascript"));
    EXPECT_EQ(get("/secret/state").status, 200);
}

TEST_F(Page, OtherNamesOfTheServerAreRefused) {
    for (const char* own : {"127.0.0.1:8000", "127.0.0.1", "localhost:9", "LocalHost", "[::1]:8000", "192.168.0.3:80"})
        EXPECT_TRUE(isOwnHost(own, "127.0.0.1")) << own;
    for (const char* other : {"", "evil.example", "evil.example:8000", "127.0.0.1.evil.example", "localhost.evil.example", "[evil]:80", "[",
                              "]", ":", "0x7f.1"})
        EXPECT_FALSE(isOwnHost(other, "127.0.0.1")) << other;
    EXPECT_TRUE(isOwnHost("render3:8000", "render3"));
    EXPECT_TRUE(isOwnHost("[fd00::1]:80", "fd00::1"));
    EXPECT_EQ(requests.answer({.method = "GET", .path = "/secret/state", .host = "evil.example"}).status, 403);
}

TEST_F(Page, WishesAreCheckedWordForWord) {
    render.update([](LiveState& state) { state.phase = "rendering"; });
    const std::string deep(500, '[');
    for (const std::string& bad :
         std::vector<std::string>{"", "pause", "{}", "[]", "null", "{\"wish\": 1}", "{\"wish\": \"explode\"}",
                                  "{\"wish\": \"pause\", \"more\": 1}", "{\"wish\": \"pause\"", "{\"wish\": \"\xff\"}", deep})
        EXPECT_EQ(post(bad).status, 400) << bad;
    EXPECT_FALSE(render.isPaused());
    EXPECT_EQ(post(R"({"wish": "pause"})", "http://evil.example").status, 403);
    EXPECT_EQ(post(R"({"wish": "pause"})", "null").status, 403);
    EXPECT_EQ(get("/secret/wish").status, 405);
    EXPECT_FALSE(render.isPaused());
    EXPECT_EQ(post(R"({"wish": "pause"})", "http://127.0.0.1:8000").status, 200);
    EXPECT_TRUE(render.isPaused());
    EXPECT_EQ(post(R"({"wish": "end"})").status, 409) << "the render goes on";
    EXPECT_EQ(post(R"({"wish": "stop"})").status, 200);
    EXPECT_TRUE(render.isStopAsked());
    EXPECT_EQ(post(R"({"wish": "goOn"})").status, 409) << "it has been stopped";
}

TEST_F(Page, NothingCanBeWishedBeforeRendering) {
    for (const char* wish : {"pause", "goOn", "stop", "save"})
        EXPECT_EQ(post(fmt::format(R"({{"wish": "{}"}})", wish)).status, 409) << wish;
}

TEST_F(Page, ValuesAreFloatsChannelByChannel) {
    EXPECT_EQ(get("/secret/values", {{"channels", "R"}}).status, 409) << "no image yet";
    showImage();
    const HttpAnswer answer = get("/secret/values", {{"channels", "Z,G"}});
    ASSERT_EQ(answer.status, 200);
    std::array<float, 12> values{};
    ASSERT_EQ(answer.body.size(), sizeof values);
    std::memcpy(values.data(), answer.body.data(), sizeof values);
    EXPECT_EQ(values[0], 0.5f);
    EXPECT_TRUE(std::isinf(values[1]));
    EXPECT_EQ(values[6], 2);
    EXPECT_EQ(get("/secret/values", {{"channels", "R,nonsense"}}).status, 404);
    EXPECT_EQ(get("/secret/values").status, 400);
    EXPECT_EQ(get("/secret/values", {{"channels", "R,R,R,R,R"}}).status, 400);
}

TEST_F(Page, APixelHasAllChannels) {
    showImage();
    const auto pixel = nlohmann::json::parse(get("/secret/pixel", {{"x", "2"}, {"y", "1"}}).body);
    EXPECT_EQ(pixel, nlohmann::json({{"R", 1}, {"G", 2}, {"B", 3}, {"Z", 0.5}}));
    EXPECT_TRUE(nlohmann::json::parse(get("/secret/pixel", {{"x", "3"}, {"y", "1"}}).body)["Z"].is_null());
    for (const auto& [x, y] : std::initializer_list<std::pair<const char*, const char*>>{{"1", "1"},
                                                                                         {"5", "1"},
                                                                                         {"2", "0"},
                                                                                         {"2", "3"},
                                                                                         {"-2", "1"},
                                                                                         {"2.0", "1"},
                                                                                         {"", "1"},
                                                                                         {"18446744073709551618", "1"},
                                                                                         {"x", "1"}})
        EXPECT_EQ(get("/secret/pixel", {{"x", x}, {"y", y}}).status, 400) << x << ", " << y;
}

TEST_F(Page, TheStateIsAnsweredOnceThereIsNews) {
    showImage();
    const auto state = nlohmann::json::parse(get("/secret/state").body);
    EXPECT_EQ(state["bounds"], nlohmann::json({2, 5, 1, 3}));
    EXPECT_EQ(state["channels"], nlohmann::json({"R", "G", "B", "Z"}));
    EXPECT_EQ(state["errors"], nlohmann::json::parse("[[3.0, 0.1, 0.05, 0.2]]"));
    EXPECT_EQ(state["doubt"], "few samples");
    EXPECT_EQ(state["curve"], "filmic");
    EXPECT_EQ(state["exposure"], 1.5);
    std::thread news([this] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        render.update([](LiveState& s) { s.phase = "finished"; });
    });
    const auto next = nlohmann::json::parse(get("/secret/state", {{"after", state["number"].dump()}}).body);
    news.join();
    EXPECT_EQ(next["phase"], "finished");
    EXPECT_GT(next["number"], state["number"]);
    EXPECT_EQ(get("/secret/state", {{"after", "x"}}).status, 400);
}

TEST_F(Page, ErrorsAreThinnedOut) {
    const auto image = std::make_shared<FilmImage>(1, 1);
    for (int i = 0; i < 5000; ++i) render.showImage(image, {0.1, 0.1, 0.1, ""}, i);
    const auto errors = render.state().errors;
    EXPECT_LT(errors.size(), 600u);
    EXPECT_GT(errors.size(), 200u);
    EXPECT_EQ(errors.back().seconds, 4999);
}

TEST(Token, IsNewEachTime) {
    const std::string a = randomToken(), b = randomToken();
    EXPECT_THAT(a, testing::MatchesRegex("[0-9a-f]{32}"));
    EXPECT_FALSE(isSameToken(a, b));
    EXPECT_TRUE(isSameToken(a, a));
    EXPECT_FALSE(isSameToken(a, a.substr(1)));
}

}  // namespace
}  // namespace eikonal
