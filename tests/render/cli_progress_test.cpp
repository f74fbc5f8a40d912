// How a render tells how it goes: progress for users and programs, the log file, and streams without a reader.

#include "cli.h"
#include "test_paths.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <sstream>

namespace eikonal {
namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

std::vector<std::string> linesOf(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

class Progresses : public Cli {
protected:
    /// Every line of standard error as JSON, of this event.
    static std::vector<json> events(const Outcome& run, const std::string& event) {
        std::vector<json> all;
        for (const std::string& line : linesOf(run.error)) {
            const json each = json::parse(line);
            if (each.at("event") == event) all.push_back(each);
        }
        return all;
    }

    /// Runs a command of the shell, with the program as $0.
    Outcome shell(const std::string& command) {
        program_ = "/bin/bash";
        return run({"-c", "set -o pipefail; " + command, EIKONAL_BINARY});
    }

    /// What the program writes to a terminal of so many columns.
    std::string onTerminal(int columns, std::vector<std::string> words, const Environment& environment = {}) {
        struct winsize size {};
        size.ws_col = static_cast<unsigned short>(columns);
        size.ws_row = 24;
        int terminal = -1;
        const int process = ::forkpty(&terminal, nullptr, nullptr, &size);
        if (process == 0) {
            ::setenv("EIKONAL_CACHE_DIR", (std::filesystem::path(EIKONAL_BINARY).parent_path() / "test-cache").c_str(), 1);
            ::unsetenv("POCL_CACHE_DIR");   // the program chooses one itself
            for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
            words.insert(words.begin(), EIKONAL_BINARY);
            std::vector<char*> arguments;
            for (std::string& w : words) arguments.push_back(w.data());
            arguments.push_back(nullptr);
            if (::chdir(path("").c_str()) == 0) ::execv(EIKONAL_BINARY, arguments.data());
            ::_exit(127);
        }
        std::string text;
        char part[4096];
        for (ssize_t got = 0; (got = ::read(terminal, part, sizeof part)) > 0;) text.append(part, static_cast<size_t>(got));
        ::close(terminal);
        int status = -1;
        ::waitpid(process, &status, 0);
        EXPECT_TRUE(WIFEXITED(status));
        status_ = WEXITSTATUS(status);
        return text;
    }
    int status_ = -1;
};

TEST_F(Progresses, JsonIsOneObjectALine) {
    write("warned.pbrt", tinyScene("", "LightSource \"infinite\" \"float scle\" 2"));
    const Outcome run =
        this->run({"render", "warned.pbrt", "-o", "a.exr", "--spp", "100000000", "--time-limit", "2.5", "--progress=json"});
    ASSERT_EQ(run.status, 4) << run.error;
    const std::vector<json> progress = events(run, "progress");
    ASSERT_GE(progress.size(), 2u) << run.error;
    double before = 0;
    for (const json& p : progress) {
        EXPECT_EQ(p.at("samplesInAll"), 100000000);
        EXPECT_GE(p.at("samplesDone").get<std::uint64_t>() + 0., before);
        EXPECT_LT(p.at("fraction").get<double>(), 1e-2);
        EXPECT_LE(p.at("secondsLeft").get<double>(), 2.5) << "the limit ends it";
        before = p.at("samplesDone").get<double>();
    }
    const json& error = progress.back().at("error");
    EXPECT_EQ(error.at("metric"), "relmse-root");
    EXPECT_LE(error.at("low").get<double>(), error.at("value").get<double>());
    EXPECT_GE(error.at("high").get<double>(), error.at("value").get<double>());
    const std::vector<json> messages = events(run, "message");
    EXPECT_TRUE(std::ranges::any_of(messages, [](const json& m) {
        return m.at("level") == "warning" && m.at("text").get<std::string>().find("\"float scle\" is ignored") != std::string::npos;
    })) << run.error;
}

TEST_F(Progresses, JsonEndsWithAllSamples) {
    const Outcome run = this->run({"render", "tiny.pbrt", "-o", "a.exr", "--progress=json", "--quiet"});
    ASSERT_EQ(run.status, 0) << run.error;
    const std::vector<json> progress = events(run, "progress");
    ASSERT_FALSE(progress.empty());
    EXPECT_EQ(progress.back().at("fraction"), 1);
    EXPECT_EQ(progress.back().at("samplesDone"), 4);
    EXPECT_EQ(progress.back().at("samplesInAll"), 4);
    EXPECT_EQ(progress.back().at("secondsLeft"), 0);
    EXPECT_TRUE(events(run, "message").empty()) << "--quiet";
}

/// Before it has a plan, it counts with the most samples that are allowed.
TEST_F(Progresses, AdaptiveSamplingIsNotDoneBeforeItIs) {
    const Outcome run = this->run({"render", "tiny.pbrt", "-o", "a.exr", "--spp", "4096", "--max-error", "1e-9", "--progress=json"});
    ASSERT_EQ(run.status, 0) << run.error;
    std::vector<json> progress = events(run, "progress");
    ASSERT_GE(progress.size(), 2u);
    EXPECT_EQ(progress.back().at("fraction"), 1);
    EXPECT_LE(progress.front().at("fraction").get<double>(), 32. / 4096);
    EXPECT_TRUE(progress.front().at("secondsLeft").is_null());
    progress.pop_back();
    for (const json& p : progress) EXPECT_LT(p.at("fraction").get<double>(), 1) << "that is for the end";
}

TEST_F(Progresses, JsonAlsoHoldsErrors) {
    const Outcome run = this->run({"render", "absent.pbrt", "--progress=json"});
    EXPECT_EQ(run.status, 1);
    const std::vector<json> messages = events(run, "message");
    ASSERT_EQ(messages.size(), 1u) << run.error;
    EXPECT_EQ(messages[0].at("level"), "error");
    EXPECT_THAT(messages[0].at("text").get<std::string>(), HasSubstr("absent.pbrt"));
}

TEST_F(Progresses, OpenJobDescriptionReadsPercentages) {
    const Outcome run = this->run({"render", "tiny.pbrt", "-o", "a.exr", "--spp", "20000", "--progress=openjd"});
    ASSERT_EQ(run.status, 0) << run.error;
    double before = -1;
    int statuses = 0;
    for (const std::string& line : linesOf(run.error)) {
        if (line.starts_with("openjd_status: ")) ++statuses;
        if (!line.starts_with("openjd_progress: ")) continue;
        EXPECT_THAT(line, MatchesRegex("openjd_progress: [0-9]+\\.[0-9]"));
        const double percent = std::stod(line.substr(17));
        EXPECT_GE(percent, before);
        before = percent;
    }
    EXPECT_EQ(before, 100);
    EXPECT_GE(statuses, 2);
    EXPECT_THAT(run.error, ContainsRegex("openjd_status: rendering, [0-9:]+ left, [0-9]+/20000 samples, [0-9:]+ elapsed"));
}

/// Its reader obeys lines that begin with openjd_, and a file may be called like that.
TEST_F(Progresses, OpenJobDescriptionTakesNoOrdersFromAFile) {
    write("openjd_env: PATH=x.pbrt", "WorldBegin\nNonsense\n");
    const Outcome run = this->run({"render", "openjd_env: PATH=x.pbrt", "--progress=openjd"});
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.error, testing::StartsWith(" openjd_env: PATH=x.pbrt:2:1: "));
    EXPECT_THAT(run.error, HasSubstr("\nopenjd_fail: openjd_env: PATH=x.pbrt:2:1: "));
}

TEST_F(Progresses, TheBarFitsTheTerminal) {
    for (const int columns : {20, 40, 100}) {
        const std::string text = onTerminal(columns, {"render", "tiny.pbrt", "-o", "a.exr", "--spp", "40000"});
        EXPECT_EQ(status_, 0) << text;
        /* What is drawn between returns and line ends, without the sequence that clears the rest of a line */
        int bars = 0;
        std::string line;
        for (size_t i = 0; i <= text.size(); ++i) {
            if (i < text.size() && text[i] != '\r' && text[i] != '\n') { line += text[i]; continue; }
            if (const size_t end = line.find("\x1b[K"); end != std::string::npos) line.resize(end);
            if (line.find(" %  ") != std::string::npos && line[0] == '[') {
                EXPECT_LT(line.size(), static_cast<size_t>(columns)) << line;
                ++bars;
            }
            line.clear();
        }
        EXPECT_GT(bars + (columns < 30), 0) << text;
    }
}

TEST_F(Progresses, ATerminalShowsHowManyKernelsAreCompiled) {
    const std::string text =
        onTerminal(40, {"render", "tiny.pbrt", "-o", "a.exr", "--nthreads", "2"}, {{"EIKONAL_CACHE_DIR", path("cache")}});
    EXPECT_EQ(status_, 0) << text;
    EXPECT_THAT(text, ContainsRegex("\rcompiling kernels: [0-9]+ of [0-9]+, [0-9]+ s\x1b"));
    EXPECT_THAT(text, ContainsRegex("\rcompiling kernels: [1-9][0-9]* of [0-9]+, [0-9]+ s\x1b"));
}

TEST_F(Progresses, AnUnknownFormIsAnError) {
    const Outcome run = this->run({"render", "tiny.pbrt", "--progress=jsn"});
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.error, "error: --progress is one of auto, bar, plain, json, openjd, not \"jsn\"; did you mean json?\n");
}

TEST_F(Progresses, TheLogHasMessagesWithTheTime) {
    for (int i = 0; i < 2; ++i) {
        const Outcome run = this->run({"render", "tiny.pbrt", "-o", "a.exr", "--quiet", "--log-file", "a.log"});
        ASSERT_EQ(run.status, 0) << run.error;
        EXPECT_EQ(run.error, "");
    }
    int begins = 0, ends = 0;
    for (const std::string& line : linesOf(read(path("a.log")))) {
        EXPECT_THAT(line, MatchesRegex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z .*"));
        const std::string text = line.substr(21);
        begins += text.find("render tiny.pbrt -o a.exr --quiet --log-file a.log") != std::string::npos;
        ends += text == "exit status 0";
    }
    EXPECT_EQ(begins, 2) << "it is appended to";
    EXPECT_EQ(ends, 2);
    EXPECT_THAT(read(path("a.log")), HasSubstr("rendering 16 x 12 pixels, 4 samples each"));
    EXPECT_THAT(read(path("a.log")), ContainsRegex("wrote a.exr and a.png in"));
}

TEST_F(Progresses, ALogReplacesNoOtherFile) {
    const std::string scene = read(path("tiny.pbrt"));
    const Outcome run = this->run({"render", "tiny.pbrt", "--log-file", "tiny.pbrt"});
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.error, "error: --log-file: \"tiny.pbrt\" is there already and is no log of eikonal; name another file\n");
    EXPECT_EQ(read(path("tiny.pbrt")), scene);
    const Outcome absent = this->run({"render", "tiny.pbrt", "--log-file", "absent/a.log"});
    EXPECT_EQ(absent.status, 1);
    EXPECT_EQ(absent.error, "error: cannot write \"absent/a.log\": No such file or directory\n");
}

TEST_F(Progresses, AReaderThatHasGoneEndsNothing) {
    const Outcome run = shell("\"$0\" render tiny.pbrt -o a.exr --spp 20000 --log-level debug --progress=json 2>&1 | head -1");
    EXPECT_EQ(run.status, 0) << "pipefail";
    EXPECT_EQ(linesOf(run.out).size(), 1u);
    EXPECT_EQ(image("a.exr").pixelCount(), 16u * 12u);
}

TEST_F(Progresses, ResultsThatNobodyReadsAreNoError) {
    EXPECT_EQ(shell("\"$0\" render tiny.pbrt -o a.exr --stats | true").status, 0);
    EXPECT_TRUE(exists("a.exr"));
}

/// A file that is opened must not take the place of a stream, or messages would be written into it.
TEST_F(Progresses, ClosedStreamsEndNothing) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "whole.exr"}).status, 0);
    const auto expected = image("whole.exr").color;
    for (const char* closed : {"2>&-", ">&-", "<&-", "<&- >&- 2>&-"}) {
        const std::string command = "rm -f a.exr; \"$0\" render tiny.pbrt -o a.exr --log-level debug --log-file a.log ";
        const Outcome run = shell(command + closed);
        EXPECT_EQ(run.status, 0) << closed << run.error;
        EXPECT_EQ(image("a.exr").color, expected) << closed;
    }
    EXPECT_THAT(read(path("a.log")), Not(HasSubstr("warning")));
}

/// The image is there, but what was asked for could not be printed.
TEST_F(Progresses, PrintingOnAClosedStreamIsAnErrorAfterTheImage) {
    const Outcome run = shell("\"$0\" render tiny.pbrt -o a.exr --json >&-");
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.error, HasSubstr("cannot write to standard output: Bad file descriptor\n"));
    EXPECT_TRUE(exists("a.exr"));
}

}  // namespace
}  // namespace eikonal
