// Prints, as JSON, how far kernels built with some math flags differ from those built with the first set of flags:
//
//     flag_ulps functions FLAGS ...         single functions, also from long double
//     flag_ulps stages SCENE FLAGS ...      whole stages, on the queues of a scene
//
// tests/accuracy/flags.py makes the tables of docs/numerics.md from it. EIKONAL_TEST_DEVICE chooses the device.

#include "flags/function_twins.h"
#include "flags/stage_comparison.h"
#include "kernels/stage.h"
#include "pack/pack.h"
#include "render/scene_loading.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdlib>

using namespace eikonal;

static nlohmann::json asJson(const UlpTally& t) { return {{"largest", t.largest}, {"rms", t.rms()}, {"values", t.values}}; }

static PackedScene load(const std::string& path) {
    SceneOptions options;
    options.path = path;
    options.resolution = {32, 32};
    options.environmentGuide = EnvironmentGuide::never;
    Diagnostics diagnostics(LogLevel::error);
    return packScene(loadScene(options, diagnostics), diagnostics);
}

int main(int count, char** words) {
    /* One thread: the order of items in queues does not change from run to run */
    ::setenv("POCL_MAX_PTHREAD_COUNT", "1", 0);
    const std::vector<std::string> arguments(words + 1, words + count);
    try {
        nlohmann::json rows = nlohmann::json::array();
        if (arguments.size() >= 2 && arguments[0] == "functions")
            for (const FunctionFigures& f : compareFunctions({arguments.begin() + 1, arguments.end()}))
                rows.push_back(
                    {{"function", f.function}, {"flags", f.flags}, {"twin", asJson(f.fromTwin)}, {"first", asJson(f.fromFirst)}});
        else if (arguments.size() >= 3 && arguments[0] == "stages")
            for (const StageFigures& f : compareStages(load(arguments[1]), {arguments.begin() + 2, arguments.end()}))
                rows.push_back(
                    {{"stage", f.stage}, {"flags", f.flags}, {"ulps", asJson(f.floats)}, {"items", f.items}, {"decided", f.decided}});
        else throw UsageError("flag_ulps functions FLAGS ...; flag_ulps stages SCENE FLAGS ...");
        fmt::print("{}\n", rows.dump(1));
    } catch (const std::exception& e) {
        fmt::print(stderr, "flag_ulps: {}\n", e.what());
        return 1;
    }
}
