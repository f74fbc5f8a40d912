#include "app/stored_metadata.h"

#include "error.h"
#include "json_text.h"
#include "names.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace eikonal {

using Json = nlohmann::ordered_json;

std::string toJson(const StoredMetadata& stored) {
    const Metadata& m = stored.metadata;
    Json json{{"seed", m.seed.value_or(0)},
              {"version", m.version},
              {"scene", m.scene},
              {"sceneHash", m.sceneHash},
              {"device", m.device},
              {"biasedChoices", m.biasedChoices},
              {"errorMetric", nameIn(errorMetricNames, stored.metric)},
              {"channels", Json::array()}};
    if (m.targetError) json["targetError"] = *m.targetError;
    if (m.worldToCamera) json["worldToCamera"] = *m.worldToCamera;
    if (m.worldToNdc) json["worldToNDC"] = *m.worldToNdc;
    for (const AovName& each : aovNames)
        if (stored.aovs.*each.asked) json["channels"].push_back(each.name);
    return jsonText(json);
}

StoredMetadata storedMetadata(const std::string& text, const std::string& name) {
    StoredMetadata stored;
    try {
        const Json json = Json::parse(text);
        Metadata& m = stored.metadata;
        m.seed = json.at("seed").get<int>();
        m.version = json.at("version");
        m.scene = json.at("scene");
        m.sceneHash = json.at("sceneHash");
        m.device = json.at("device");
        m.biasedChoices = json.at("biasedChoices");
        if (json.contains("targetError")) m.targetError = json["targetError"].get<double>();
        if (json.contains("worldToCamera")) m.worldToCamera = json["worldToCamera"].get<std::array<float, 16>>();
        if (json.contains("worldToNDC")) m.worldToNdc = json["worldToNDC"].get<std::array<float, 16>>();
        for (const auto& [metric, value] : errorMetricNames)
            if (json.at("errorMetric") == metric) stored.metric = value;
        for (const std::string channel : json.at("channels"))
            for (const AovName& each : aovNames)
                if (each.name == channel) stored.aovs.*each.asked = true;
    } catch (const Json::exception& error) {
        throw Error(ExitCode::scene, fmt::format("{}: is damaged: {}", name, error.what()));
    }
    return stored;
}

}  // namespace eikonal
