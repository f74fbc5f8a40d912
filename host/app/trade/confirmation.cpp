#include "app/trade/confirmation.h"

#include "app/trade/setting_renderer.h"
#include "child_process.h"
#include "clock.h"
#include "error.h"
#include "names.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <sstream>

namespace eikonal {

static std::string contentOf(const std::string& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

Confirmation confirm(const std::string& scene, const std::vector<std::string>& options, const std::string& folder) {
    const std::string out = folder + "/confirmation.json", err = folder + "/confirmation.txt";
    std::vector<std::string> arguments{"eikonal", "render", scene, "-o", folder + "/confirmation.exr", "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Stopwatch time;
    const pid_t process = startSelf(arguments, out, err);
    const int status = process ? exitStatusOf(process) : -1;
    Confirmation c;
    c.wallSeconds = time.seconds();
    const nlohmann::json json = nlohmann::json::parse(contentOf(out), nullptr, false);
    if (status != 0 || !json.is_object()) throw Error(ExitCode::scene, fmt::format("eikonal render {} failed: {}", scene, contentOf(err)));
    c.renderSeconds = json.at("seconds").at("render");
    c.compileSeconds = json.at("seconds").at("compile");
    c.meanSamples = json.at("samples").at("mean");
    const nlohmann::json error = json.value("error", nlohmann::json::object());
    const auto number = [&](const char* key) { return error.contains(key) && error.at(key).is_number() ? error.at(key).get<double>() : 0; };
    if (error.value("metric", "") == nameIn(errorMetricNames, studyMetric) && number("low") > 0) {
        c.ownError = number("value");
        c.errorDeviation = std::log(number("high") / number("low")) / (2 * 1.96);
    }
    return c;
}

}  // namespace eikonal
