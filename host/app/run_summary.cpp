#include "app/run_summary.h"

#include "clock.h"

#include <nlohmann/json.hpp>

namespace eikonal {

std::string describeAsJson(const Session& session, const std::vector<std::string>& files, const Metadata& metadata,
                           const FilmTotals::Samples& samples, const RenderResult& result, int endedBy, double writeSeconds,
                           const std::vector<std::string>& warnings) {
    const SessionTimes& t = session.times();
    nlohmann::ordered_json json{{"files", files},
                                {"isComplete", result.isFinished},
                                {"scene", metadata.scene},
                                {"sceneHash", metadata.sceneHash},
                                {"seed", metadata.seed.value_or(0)},
                                {"version", metadata.version},
                                {"device", metadata.device},
                                {"commandLine", metadata.commandLine},
                                {"samples", {{"fewest", samples.fewest}, {"mean", samples.mean}, {"most", samples.most}}}};
    if (endedBy) json["signal"] = endedBy;
    if (metadata.error) {
        json["error"] = {
            {"metric", metadata.errorMetric}, {"value", *metadata.error}, {"low", *metadata.errorLow}, {"high", *metadata.errorHigh}};
        if (!metadata.errorDoubt.empty()) json["error"]["doubt"] = metadata.errorDoubt;
    }
    json["seconds"] = {{"read", t.load},        {"pack", t.pack},
                       {"build", t.build},      {"compile", t.compile},
                       {"upload", t.upload},    {"render", metadata.renderSeconds.value_or(0)},
                       {"write", writeSeconds}, {"all", secondsSinceStart()}};
    json["compiledKernels"] = session.compiledStages();
    json["biasedChoices"] = nlohmann::ordered_json::array();
    for (const BiasedChoice& c : session.biasedChoices()) json["biasedChoices"].push_back({{"what", c.what}, {"remedy", c.remedy}});
    json["warnings"] = warnings;
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace eikonal
