#include "app/trade/confirmation.h"

#include "clock.h"
#include "error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

namespace eikonal {

static std::string contentOf(const std::string& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Runs this program with its standard streams in files. Returns its status as waitpid does.
static int runSelf(const std::vector<std::string>& arguments, const std::string& out, const std::string& err) {
    std::vector<char*> words;
    for (const std::string& a : arguments) words.push_back(const_cast<char*>(a.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    pid_t process = 0;
    const int failure = posix_spawn(&process, "/proc/self/exe", &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure) return -1;
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {}
    return status;
}

Confirmation confirm(const std::string& scene, const std::vector<std::string>& options, const std::string& folder) {
    const std::string out = folder + "/confirmation.json", err = folder + "/confirmation.txt";
    std::vector<std::string> arguments{"eikonal", "render", scene, "-o", folder + "/confirmation.exr", "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Stopwatch time;
    const int status = runSelf(arguments, out, err);
    Confirmation c;
    c.wallSeconds = time.seconds();
    const nlohmann::json json = nlohmann::json::parse(contentOf(out), nullptr, false);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || !json.is_object())
        throw Error(ExitCode::scene, fmt::format("eikonal render {} failed: {}", scene, contentOf(err)));
    c.renderSeconds = json.at("seconds").at("render");
    c.compileSeconds = json.at("seconds").at("compile");
    c.meanSamples = json.at("samples").at("mean");
    return c;
}

}  // namespace eikonal
