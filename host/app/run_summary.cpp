#include "app/run_summary.h"

#include "json_text.h"

#include <nlohmann/json.hpp>

namespace eikonal {

static nlohmann::ordered_json asJson(const RenderIdentity::Values& values) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const auto& [name, value] : values) json[name] = value;
    return json;
}

std::string describeAsJson(const Session& session, const RunSummary& run) {
    const SessionTimes& t = session.times();
    const Metadata& metadata = run.metadata;
    nlohmann::ordered_json json{{"files", run.files},
                                {"checkpoint", run.checkpoint.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(run.checkpoint)},
                                {"isComplete", run.isComplete},
                                {"status", run.status},
                                {"scene", metadata.scene},
                                {"sceneHash", metadata.sceneHash},
                                {"hashes", {{"tables", asJson(run.identity.tables)}, {"files", asJson(run.identity.files)}}},
                                {"settings", asJson(run.identity.settings)},
                                {"seed", metadata.seed.value_or(0)},
                                {"version", metadata.version},
                                {"device", metadata.device},
                                {"commandLine", metadata.commandLine},
                                {"samples", {{"fewest", run.samples.fewest}, {"mean", run.samples.mean}, {"most", run.samples.most}}}};
    if (run.frame) json["frame"] = *run.frame;
    if (run.endedBy) json["signal"] = run.endedBy;
    if (metadata.error) {
        json["error"] = {
            {"metric", metadata.errorMetric}, {"value", *metadata.error}, {"low", *metadata.errorLow}, {"high", *metadata.errorHigh}};
        if (!metadata.errorDoubt.empty()) json["error"]["doubt"] = metadata.errorDoubt;
    }
    if (metadata.firefliesShare) json["firefliesShare"] = *metadata.firefliesShare;
    json["seconds"] = {{"read", t.load},
                       {"pack", t.pack},
                       {"build", t.build},
                       {"compile", t.compile},
                       {"upload", t.upload},
                       {"render", metadata.renderSeconds.value_or(0)},
                       {"write", run.writeSeconds},
                       {"all", session.seconds()}};
    json["compiledKernels"] = session.compiledStages();
    json["biasedChoices"] = nlohmann::ordered_json::array();
    for (const BiasedChoice& c : session.biasedChoices()) json["biasedChoices"].push_back({{"what", c.what}, {"remedy", c.remedy}});
    json["warnings"] = run.warnings;
    return jsonText(json) + "\n";
}

std::string describeSkipped(const Options& options, const std::vector<std::string>& files) {
    nlohmann::ordered_json json{
        {"files", files}, {"isSkipped", true}, {"isComplete", true}, {"status", 0}, {"scene", options.scene.path}};
    if (options.scene.frame) json["frame"] = *options.scene.frame;
    return jsonText(json) + "\n";
}

}  // namespace eikonal
