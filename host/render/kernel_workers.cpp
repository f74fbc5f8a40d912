#include "render/kernel_workers.h"

#include "child_process.h"
#include "render/open_device.h"
#include "render/session.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <thread>

namespace eikonal {
namespace {

/// Starting a worker takes about as long as compiling one stage, so each should compile at least two.
constexpr int stagesWorthAWorker = 2, mostWorkers = 8;

std::string bitsOf(const Features& features) {
    std::string bits;
    for (size_t i = 0; i < featureCount(); ++i) bits += features.has(static_cast<Feature>(i)) ? '1' : '0';
    return bits;
}

Features featuresOf(const std::string& bits) {
    Features features;
    for (size_t i = 0; i < std::min(bits.size(), featureCount()); ++i)
        if (bits[i] == '1') features.require(static_cast<Feature>(i));
    return features;
}

/// Makes this process end when `parent` ends for any reason, since its kernels are then useless. Returns whether the parent still runs.
bool endWith(pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    return ::getppid() == parent;
}

/// Tables of zeros, long enough for launches over no items: straight-line kernels load from them, but discard the values.
PackedScene emptyScene(const CompileRequest& request) {
    PackedScene scene;
    scene.features = featuresOf(request.features);
    scene.constants = SceneConstants::fromText(request.constants);
    constexpr size_t elements = 2 * MOST_FILTER_CELLS;
#define FILL_WITH_ZEROS(type, name) scene.tables.name.resize(elements);
    SCENE_TABLES(FILL_WITH_ZEROS)
#undef FILL_WITH_ZEROS
    return scene;
}

}  // namespace

void compileInWorkers(const DeviceOptions& o, const PackedScene& scene, int missing, const std::function<void()>& stepDone) {
    const int cores = o.threads > 0 ? o.threads : static_cast<int>(std::thread::hardware_concurrency());
    const int workers = std::min({cores, missing / stagesWorthAWorker, mostWorkers});
    if (workers < 2) return;
    int steps[2];   // a pipe: a byte for each step of each worker
    if (::pipe2(steps, O_CLOEXEC) != 0) return;
    std::vector<pid_t> processes;
    for (int i = 0; i < workers; ++i) {
        std::vector<std::string> arguments{"eikonal",
                                           "compile-kernels",
                                           bitsOf(scene.features),
                                           scene.constants.text(),
                                           std::to_string(i),
                                           std::to_string(workers),
                                           std::to_string(::getpid()),
                                           "--contraction",
                                           o.contraction ? "on" : "off",
                                           "--nthreads",
                                           "1"};
        if (!o.buildOptions.empty()) arguments.push_back("--build-options=" + o.buildOptions);
        for (const StageFlags& s : o.mathFlags) arguments.push_back("--math-flags=" + s.stage + ":" + s.flags);
        if (!o.device.empty()) arguments.insert(arguments.end(), {"--device", o.device});
        if (o.localSize) arguments.insert(arguments.end(), {"--local-size", std::to_string(*o.localSize)});
        if (o.itemsPerWorkItem) arguments.insert(arguments.end(), {"--items-per-work-item", std::to_string(*o.itemsPerWorkItem)});
        if (o.wavePaths) arguments.insert(arguments.end(), {"--wave-paths", std::to_string(*o.wavePaths)});
        if (const pid_t process = startSelf(arguments, steps[1])) processes.push_back(process);
    }
    ::close(steps[1]);
    char step = 0;
    for (ssize_t size = 1; size != 0; size = ::read(steps[0], &step, 1)) {
        if (size < 0 && errno != EINTR) break;
        if (step) stepDone();
        step = 0;
    }
    ::close(steps[0]);
    for (const pid_t process : processes) exitStatusOf(process);
}

void compileKernels(const DeviceOptions& o, const CompileRequest& request) {
    if (request.parent && !endWith(request.parent)) return;
    prepareOpenCl(o);
    OpenDevice device(o, false);
    const PackedScene scene = emptyScene(request);
    const DeviceScene tables(device.context, scene);
    Profile profile;
    Stages stages(device.compiler, scene, device.shape, buildSettingsFor(o), {request.part, request.parts},
                  [] { [[maybe_unused]] const ssize_t size = ::write(STDOUT_FILENO, ".", 1); });
    Wave wave(device.context, tables, scene, stages, device.shape, profile);
    wave.warmUp();
    stages.keep(device.compiler);
}

}  // namespace eikonal
