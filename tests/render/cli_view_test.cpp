// The page that shows a render: --view. tests/structure/view_page.py opens it in a browser.

#include "cli.h"
#include "same_files.h"

#include <gmock/gmock.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <thread>

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace eikonal {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class View : public Cli {
protected:
    /// Starts a render with a page.
    Running watch(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"render", "tiny.pbrt", "--view"});
        Running running = start(arguments);
        EXPECT_TRUE(printed(running, "view: http://127.0.0.1:"));
        std::ifstream file(running.error);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        const auto begin = text.find("view: http://127.0.0.1:") + 23, slash = text.find('/', begin);
        port = std::stoi(text.substr(begin, slash - begin));
        token = text.substr(slash + 1, 32);
        return running;
    }

    /// What the server answers to these bytes; empty: it cannot be reached, or says nothing.
    std::string send(const std::string& bytes) const {
        const int connection = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        std::string answer;
        if (::connect(connection, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) {
            for (std::size_t sent = 0; sent < bytes.size();) {
                const ssize_t some = ::send(connection, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
                if (some <= 0) break;
                sent += static_cast<std::size_t>(some);
            }
            char buffer[4096];
            for (ssize_t got; (got = ::read(connection, buffer, sizeof buffer)) > 0;) answer.append(buffer, static_cast<std::size_t>(got));
        }
        ::close(connection);
        return answer;
    }
    std::string get(const std::string& path, const std::string& more = "", const std::string& host = "127.0.0.1") const {
        return send("GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\n" + more + "\r\n");
    }
    std::string wish(const std::string& body) const {
        return send("POST /" + token + "/wish HTTP/1.1\r\nHost: localhost\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" +
                    body);
    }
    /// Waits until the state has this text; false: it has not, for 60 seconds.
    bool becomes(const std::string& text) const {
        for (int i = 0; i < 600; ++i) {
            if (get("/" + token + "/state").find(text) != std::string::npos) return true;
            ::usleep(100'000);
        }
        return false;
    }

    int port = 0;
    std::string token;
};

TEST_F(View, BeingWatchedChangesNoBits) {
    EXPECT_EQ(run({"render", "tiny.pbrt", "-o", "a.exr", "--spp", "3000", "--aov", "all"}).status, 0);
    const Running running = watch({"-o", "b.exr", "--spp", "3000", "--aov", "all"});
    EXPECT_TRUE(becomes("\"phase\":\"rendering\""));
    EXPECT_THAT(wish(R"({"wish": "pause"})"), HasSubstr("200"));
    EXPECT_TRUE(becomes("\"phase\":\"paused\""));
    EXPECT_TRUE(becomes("\"channels\":[\"R\""));
    EXPECT_GT(get("/" + token + "/values?channels=R,G,B").size(), 16u * 12 * 3 * 4);
    EXPECT_THAT(wish(R"({"wish": "goOn"})"), HasSubstr("200"));
    while (!get("/" + token + "/values?channels=R,G,B").empty()) {}
    EXPECT_EQ(wait(running).status, 0);
    expectSameFiles(path("a.exr"), path("b.exr"));
}

TEST_F(View, StopIsCtrlC) {
    const Running running = watch({"-o", "a.exr", "--spp", "100000000"});
    EXPECT_TRUE(becomes("\"phase\":\"rendering\""));
    EXPECT_THAT(wish(R"({"wish": "save"})"), HasSubstr("200"));
    EXPECT_TRUE(becomes("\"saves\":1"));
    EXPECT_TRUE(exists("a.exr"));
    EXPECT_THAT(wish(R"({"wish": "pause"})"), HasSubstr("200"));
    EXPECT_THAT(wish(R"({"wish": "stop"})"), HasSubstr("200"));
    const Outcome run = wait(running);
    EXPECT_EQ(run.status, 128 + SIGINT);
    EXPECT_THAT(run.error, HasSubstr("interrupted: "));
}

TEST_F(View, APausedRenderHearsSignalsAndLimits) {
    for (const bool isSignal : {true, false}) {
        std::vector<std::string> arguments{"-o", "a.exr", "--spp", "100000000"};
        if (!isSignal) arguments.insert(arguments.end(), {"--time-limit", "3"});
        const Running running = watch(arguments);
        EXPECT_TRUE(becomes("\"phase\":\"rendering\""));
        EXPECT_THAT(wish(R"({"wish": "pause"})"), HasSubstr("200"));
        if (isSignal) ::kill(running.process, SIGTERM);
        const Outcome run = wait(running);
        EXPECT_EQ(run.status, isSignal ? 128 + SIGTERM : 4) << run.error;
        EXPECT_LT(run.seconds, 30);
    }
}

TEST_F(View, ThePageStaysIfAskedTo) {
    const Running running = watch({"-o", "a.exr", "--view-wait"});
    EXPECT_TRUE(becomes("\"phase\":\"finished\",\"hasEnded\":true"));
    EXPECT_TRUE(exists("a.exr"));
    EXPECT_THAT(get("/" + token + "/pixel?x=8&y=6"), HasSubstr("\"R\":0."));
    EXPECT_THAT(wish(R"({"wish": "end"})"), HasSubstr("200"));
    EXPECT_EQ(wait(running).status, 0);
}

TEST_F(View, HostileRequestsAreRefused) {
    const Running running = watch({"-o", "a.exr", "--spp", "100000000"});
    const std::string state = "/" + token + "/state", page = "/" + token + "/";
    EXPECT_THAT(get(page), HasSubstr("Content-Security-Policy: default-src 'none'"));
    EXPECT_THAT(get("/"), StartsWith("HTTP/1.1 404"));
    EXPECT_THAT(get("/" + std::string(32, '0') + "/state"), StartsWith("HTTP/1.1 404"));
    EXPECT_THAT(get(state, "", "evil.example"), StartsWith("HTTP/1.1 403")) << "DNS rebinding";
    EXPECT_THAT(send("GET " + state + " HTTP/1.1\r\n\r\n"), StartsWith("HTTP/1.1 403")) << "no host";
    EXPECT_THAT(send("DELETE " + state + " HTTP/1.1\r\nHost: localhost\r\n\r\n"), StartsWith("HTTP/1.1 4"));
    EXPECT_THAT(get("/" + token + "/../../etc/passwd"), StartsWith("HTTP/1.1 4"));
    EXPECT_THAT(wish("{\"wish\": [" + std::string(900, '[')), StartsWith("HTTP/1.1 400"));
    EXPECT_EQ(wish(std::string(2000, 'x')).find("HTTP/1.1 200"), std::string::npos) << "a long body";
    const auto isRefused = [](const std::string& answer) { return answer.empty() || answer.starts_with("HTTP/1.1 4"); };
    EXPECT_TRUE(isRefused(get(state, "X: " + std::string(20000, 'x') + "\r\n"))) << "a long header";
    std::string many;
    for (int i = 0; i < 5000; ++i) many += "X" + std::to_string(i) + ": y\r\n";
    EXPECT_TRUE(isRefused(get(state, many))) << "many headers";
    EXPECT_TRUE(isRefused(get("/" + std::string(100000, 'x')))) << "a long address";
    EXPECT_TRUE(isRefused(send(std::string(1 << 20, '\n'))));
    EXPECT_TRUE(isRefused(send(std::string(1 << 20, '\0'))));
    EXPECT_TRUE(isRefused(send("GET\r\n\r\n")));
    EXPECT_FALSE(get(page, "Range: bytes=" + std::string(7000, '0') + "-1,0-1\r\n").empty());
    EXPECT_EQ(send("POST /" + token + "/wish HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\nFFFFFFF\r\n" +
                   std::string(100000, 'x'))
                  .find("HTTP/1.1 200"),
              std::string::npos)
        << "a body without end";
    EXPECT_THAT(get(state), StartsWith("HTTP/1.1 200")) << "after all of this it still serves";
    EXPECT_THAT(wish(R"({"wish": "stop"})"), testing::AnyOf(StartsWith("HTTP/1.1 200"), StartsWith("HTTP/1.1 409")));
    ::kill(running.process, SIGTERM);
    wait(running);
}

TEST_F(View, IsOfThisMachineAloneAndItsPortIsItsOwn) {
    const Running running = watch({"-o", "a.exr", "--spp", "100000000"});
    const Outcome second = run({"render", "tiny.pbrt", "--view", "--port", std::to_string(port)});
    EXPECT_EQ(second.status, 2);
    EXPECT_THAT(second.error, HasSubstr("is taken"));
    ::kill(running.process, SIGTERM);
    wait(running);
    const Outcome elsewhere = run({"render", "tiny.pbrt", "--view", "--view-address", "192.0.2.1"});
    EXPECT_EQ(elsewhere.status, 2);
    EXPECT_THAT(elsewhere.error, HasSubstr("192.0.2.1"));
    const Outcome alone = run({"render", "tiny.pbrt", "--port", "8000"});
    EXPECT_EQ(alone.status, 2);
    EXPECT_THAT(alone.error, HasSubstr("--view"));
}

}  // namespace
}  // namespace eikonal
