#include "film/stored_scene.h"

#include "error.h"
#include "json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace eikonal {
namespace {

using Json = nlohmann::ordered_json;

std::string hex(const void* bytes, size_t count) {
    std::string text;
    for (size_t i = 0; i < count; ++i) text += fmt::format("{:02x}", static_cast<const unsigned char*>(bytes)[i]);
    return text;
}
template <class T> std::string hex(const Table<T>& table) { return hex(table.data(), table.size() * sizeof(T)); }

template <class T> Table<T> tableFrom(const std::string& text) {
    Table<T> table(text.size() / 2 / sizeof(T));
    auto* bytes = reinterpret_cast<unsigned char*>(table.data());
    for (size_t i = 0; i < table.size() * sizeof(T); ++i)
        bytes[i] = static_cast<unsigned char>(std::stoi(text.substr(2 * i, 2), nullptr, 16));
    return table;
}

}  // namespace

std::string toJson(const PackedScene& packed, const PixelRect& pixels, const FilmDescription& film) {
    Json json{{"frame", hex(&packed.frame(), sizeof(settings))},
              {"lens", hex(packed.tables.lens_elements)},
              {"wavelengths", hex(packed.tables.wavelengths)},
              {"worldScale", packed.worldScale},
              {"worldCenter", hex(&packed.worldCenter, sizeof packed.worldCenter)},
              {"cameraFromScene", hex(&packed.cameraFromScene, sizeof packed.cameraFromScene)},
              {"cameraUnit", packed.cameraUnit},
              {"pixels", {pixels.x0, pixels.y0, pixels.x1, pixels.y1}},
              {"samples", packed.samples},
              {"lightGroups", packed.constants.lightGroups > 0 ? packed.lightGroups : std::vector<std::string>()},
              {"objectManifest", packed.objectManifest},
              {"materialManifest", packed.materialManifest},
              {"gbuffer", static_cast<int>(film.gbuffer)},
              {"halfFloats", film.halfFloats}};
    for (size_t i = 0; i < featureCount(); ++i)
        if (packed.features.has(static_cast<Feature>(i))) json["features"].push_back(featureName(static_cast<Feature>(i)));
    return jsonText(json);
}

StoredScene storedScene(const std::string& text, const std::string& name) {
    StoredScene scene;
    try {
        const Json json = Json::parse(text);
        PackedScene& packed = scene.packed;
        packed.tables.frame = tableFrom<settings>(json.at("frame"));
        packed.tables.lens_elements = tableFrom<lens_element>(json.at("lens"));
        packed.tables.wavelengths = tableFrom<wavelength_range>(json.at("wavelengths"));
        packed.worldScale = json.at("worldScale");
        const auto center = tableFrom<glm::dvec3>(json.at("worldCenter"));
        const auto cameras = tableFrom<glm::dmat4>(json.at("cameraFromScene"));
        if (packed.tables.frame.size() != 1 || center.size() != 1 || cameras.size() != packed.cameraFromScene.size())
            throw Error(ExitCode::scene, fmt::format("{}: was made by another build of the program", name));
        packed.worldCenter = center.front();
        std::copy(cameras.begin(), cameras.end(), packed.cameraFromScene.begin());
        packed.cameraUnit = json.at("cameraUnit");
        const Json& p = json.at("pixels");
        packed.pixels = {p.at(0), p.at(1), p.at(2), p.at(3)};
        packed.samples = json.at("samples");
        packed.lightGroups = json.at("lightGroups").get<std::vector<std::string>>();
        packed.constants.lightGroups = static_cast<int>(packed.lightGroups.size());
        packed.objectManifest = json.at("objectManifest");
        packed.materialManifest = json.at("materialManifest");
        for (const Json& feature : json.value("features", Json::array()))
            if (const Feature known = featureNamed(feature); known != Feature::none) packed.features.require(known);
        scene.film.gbuffer = static_cast<GBuffer>(json.at("gbuffer").get<int>());
        scene.film.halfFloats = json.at("halfFloats");
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {   // of JSON, or of numbers
        throw Error(ExitCode::scene, fmt::format("{}: is damaged: {}", name, error.what()));
    }
    return scene;
}

}  // namespace eikonal
