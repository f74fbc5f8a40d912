#include "run_program.h"

#include "default_settings.h"
#include "test_paths.h"

#include <fcntl.h>
#include <sys/wait.h>

#include <chrono>
#include <thread>

namespace eikonal {

using Clock = std::chrono::steady_clock;

const std::string ProgramTest::builtProgram = EIKONAL_BINARY;

ProgramTest::Running ProgramTest::start(const std::vector<std::string>& arguments, const Environment& environment) const {
    static int count = 0;
    const std::string stem = path("run" + std::to_string(++count));
    Running running{0, stem + ".out", stem + ".err"};
    running.process = ::fork();
    if (running.process != 0) return running;

    /* In the child: where it stands, what it prints into, what it knows */
    const auto redirect = [](const std::string& file, int to) { ::dup2(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), to); };
    redirect(running.out, STDOUT_FILENO);
    redirect(running.error, STDERR_FILENO);
    const std::string cache = std::filesystem::path(EIKONAL_BINARY).parent_path() / "test-cache";
    ::setenv("EIKONAL_CACHE_DIR", cache.c_str(), 1);
    ::unsetenv("POCL_CACHE_DIR");   // the program chooses one itself
    for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
    std::vector<char*> words{const_cast<char*>(program_.c_str())};
    for (const std::string& a : arguments) words.push_back(const_cast<char*>(a.c_str()));
    words.push_back(nullptr);
    if (::chdir(folder_.c_str()) == 0) ::execv(program_.c_str(), words.data());
    ::_exit(127);
}

Outcome ProgramTest::wait(const Running& running) const {
    const auto begin = Clock::now();
    int status = 0;
    ::waitpid(running.process, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read(running.out), read(running.error),
            std::chrono::duration<double>(Clock::now() - begin).count()};
}

bool ProgramTest::printed(const Running& running, const std::string& text) {
    using namespace std::chrono_literals;
    for (const auto end = Clock::now() + 60s; Clock::now() < end; std::this_thread::sleep_for(20ms))
        if (read(running.error).find(text) != std::string::npos) return true;
    return false;
}

std::string tinyScene(const std::string& settings, const std::string& world) {
    return defaultSettings(R"(LookAt 0 0 -4  0 0 0  0 1 0
Camera "perspective" "float fov" 40
Sampler "independent" "integer pixelsamples" 4
Film "rgb" "integer xresolution" 16 "integer yresolution" 12
PixelFilter "box"
)", settings) + settings + R"(
WorldBegin
LightSource "point" "rgb I" [20 20 20] "point3 from" [0 2 -4]
)" + world + R"(
Material "diffuse" "rgb reflectance" [0.5 0.4 0.3]
Shape "trianglemesh" "point3 P" [-1 -1 0  1 -1 0  1 1 0  -1 1 0] "integer indices" [0 1 2 0 2 3]
)";
}

}  // namespace eikonal
