#include "film/stored_scene.h"

#include "error.h"
#include "json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <limits>

namespace eikonal {
namespace {

using Json = nlohmann::ordered_json;

std::string hex(const void* bytes, size_t count) {
    std::string text;
    for (size_t i = 0; i < count; ++i) text += fmt::format("{:02x}", static_cast<const unsigned char*>(bytes)[i]);
    return text;
}
template <class T> std::string hex(const Table<T>& table) { return hex(table.data(), table.size() * sizeof(T)); }

/// Of a film "spectral" (nbuckets, host/read/pbrt/setting_kinds.cpp).
constexpr int mostBuckets = 512;

template <class T> Table<T> tableFrom(const std::string& text) {
    Table<T> table(text.size() / 2 / sizeof(T));
    auto* bytes = reinterpret_cast<unsigned char*>(table.data());
    for (size_t i = 0; i < table.size() * sizeof(T); ++i)
        bytes[i] = static_cast<unsigned char>(std::stoi(text.substr(2 * i, 2), nullptr, 16));
    return table;
}

/// Throws an Error for a rectangle without pixels, or with more columns or rows than an int counts.
void requirePixels(const PixelRect& pixels, const std::string& name) {
    const auto isSide = [](std::int64_t from, std::int64_t to) { return from < to && to - from <= std::numeric_limits<int>::max(); };
    if (!isSide(pixels.x0, pixels.x1) || !isSide(pixels.y0, pixels.y1))
        throw Error(ExitCode::scene, fmt::format("{}: is damaged: its image has the columns {} to {} and the rows {} to {}", name,
                                                 pixels.x0, pixels.x1, pixels.y0, pixels.y1));
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
        if (const int buckets = static_cast<int>(packed.frame().bucket_count); buckets < 0 || buckets > mostBuckets)
            throw Error(ExitCode::scene, fmt::format("{}: is damaged: spectra of {} buckets", name, buckets));
        packed.worldCenter = center.front();
        std::copy(cameras.begin(), cameras.end(), packed.cameraFromScene.begin());
        packed.cameraUnit = json.at("cameraUnit");
        const Json& p = json.at("pixels");
        packed.pixels = {p.at(0), p.at(1), p.at(2), p.at(3)};
        requirePixels(packed.pixels, name);
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
