#include "render/render_identity.h"

#include "json_text.h"
#include "kinds/filter_kind.h"
#include "kinds/integrator_kind.h"
#include "names.h"
#include "read/formats/input_files.h"
#include "render/table_hash.h"
#include "split.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace eikonal {
namespace {

using Values = RenderIdentity::Values;
using Json = nlohmann::ordered_json;

/// The name of the setting that lists the fields of the film.
constexpr const char* keptOfPixels = "kept of each pixel";

Values tablesOf(const PackedScene& scene) {
    Values all;
#define ADD_TABLE(type, name) hash.add(scene.tables.name);
#define ADD_GROUP(title, LIST) { TableHash hash; LIST(ADD_TABLE) all.emplace_back(title, hash.text()); }
    ADD_GROUP("geometry", GEOMETRY_TABLES)
    ADD_GROUP("vertex attributes", VERTEX_TABLES)
    ADD_GROUP("textures", PROGRAM_TABLES)
    ADD_GROUP("materials", MATERIAL_TABLES)
    ADD_GROUP("measured BSDFs", BSDF_TABLES)
    ADD_GROUP("lights", LIGHT_TABLES)
    ADD_GROUP("light paths", EMISSION_TABLES)
    ADD_GROUP("media", MEDIUM_TABLES)
    ADD_GROUP("colours", COLOR_TABLES)
    ADD_GROUP("camera and filter", CAMERA_TABLES)
    ADD_GROUP("Cryptomatte IDs", MATTE_TABLES)
#undef ADD_GROUP
#undef ADD_TABLE
    TableHash frame;
    frame.add(scene.frame());
    all.emplace_back("settings", frame.text());
    return all;
}

/// A hash of the kernels' sources, which a user may change.
std::string kernelsHash(const KernelFolders& folders) {
    std::vector<std::string> files;
    for (const std::string& folder : {folders.kernels, folders.include})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            if (entry.is_regular_file()) files.push_back(entry.path().string());
    std::ranges::sort(files);
    std::uint64_t hash = hashSeed;
    for (const std::string& file : files) hash = hashBytes(contentHash(file), hash);
    return fmt::format("{:016x}", hash);
}

std::string nameOf(const std::optional<Roulette>& roulette) {
    if (!roulette) return "chosen for the scene";
    return fmt::format("{} {} from depth {}", nameIn(rouletteRuleNames, roulette->rule), roulette->scale, roulette->depth);
}

std::string nameOf(const FilmDescription& film) {
    return fmt::format("sensor {}, iso {}, exposure time {}, white balance {}, colour space {}", film.sensor, film.iso, film.exposureTime,
                       film.whiteBalance, static_cast<int>(film.colorSpace));
}

std::string nameOf(const FilterDescription& filter) {
    const FilterKind& kind = *filter.kind;
    return fmt::format("{} {} x {}", kind.name, filter.xRadius, filter.yRadius);
}

Values settingsOf(const Session& session, const SessionOptions& options, const Film& film) {
    const Scene& scene = session.scene();
    const IntegratorKind& integrator = *scene.integrator.kind;
    const PackedScene& packed = session.packed();
    const PixelRect& p = session.wholePixels();
    const settings& frame = packed.frame();
    const DeviceOptions& device = options.device;
    std::string mathFlags;
    for (const StageFlags& s : device.mathFlags) mathFlags += fmt::format("{}{}:{}", mathFlags.empty() ? "" : " ", s.stage, s.flags);
    std::string channels;
    for (const FieldLayout& field : film.layout().fields)
        if (field.words) channels += fmt::format("{}{}", channels.empty() ? "" : " ", field.name);
    return {{"version", "Eikonal " EIKONAL_VERSION},
            {"kernels", kernelsHash(session.compiler().folders())},
            {"image", fmt::format("{} x {}", frame.width, frame.height)},
            {"pixels", fmt::format("{},{},{},{}", p.x0, p.x1, p.y0, p.y1)},
            {"seed", fmt::format("{}", scene.sampler.seed)},
            {"sampler", nameIn(samplerNames, scene.sampler.kind)},
            {"integrator", integrator.name},
            {"maximum depth", fmt::format("{}", frame.max_depth)},
            {"Russian roulette", nameOf(packed.roulette)},
            {"light sampler", scene.integrator.lightSampler == LightSampler::automatic
                                  ? "auto"
                                  : nameIn(lightSamplerNames, scene.integrator.lightSampler)},
            {"environment guide", nameIn(environmentGuideNames, scene.integrator.environmentGuide)},
            {"path guiding", nameIn(pathGuidingNames, scene.integrator.guiding)},
            {"regularize", scene.integrator.regularize ? "on" : "off"},
            {"surfaces", scene.forcesDiffuse ? "all diffuse" : "as described"},
            {"maximum component value", fmt::format("{}", frame.max_component_value)},
            {"colour", packed.features.has(Feature::SPECTRAL) ? "spectral" : "rgb"},
            {"filter", nameOf(scene.filter)},
            {"film", nameOf(scene.film)},
            {keptOfPixels, channels},
            {"contraction", device.contraction ? "on" : "off"},
            {"math flags", mathFlags.empty() ? "as shipped" : mathFlags},
            {"build options", device.buildOptions}};
}

Values partOf(const Film& film) {
    const PixelRect& p = film.pixels();
    return {{"rendered part", fmt::format("{},{},{},{}", p.x0, p.x1, p.y0, p.y1)}, {"first sample", fmt::format("{}", film.firstSample())}};
}

Json asJson(const Values& values) {
    Json json = Json::object();
    for (const auto& [name, value] : values) json[name] = value;
    return json;
}

Values valuesFrom(const Json& json) {
    Values values;
    for (const auto& [name, value] : json.items()) values.emplace_back(name, value.get<std::string>());
    return values;
}

/// Describes each name whose values differ. `sentence` formats (name, value here, value there).
template <class Sentence>
std::vector<std::string> compare(const Values& here, const Values& there, Sentence sentence) {
    const auto valueIn = [](const Values& values, const std::string& name) {
        const auto found = std::ranges::find(values, name, &Values::value_type::first);
        return found == values.end() ? std::string("none") : found->second;
    };
    std::vector<std::string> found;
    for (const auto& [name, value] : here)
        if (const std::string other = valueIn(there, name); other != value) found.push_back(sentence(name, value, other));
    for (const auto& [name, value] : there)
        if (std::ranges::find(here, name, &Values::value_type::first) == here.end()) found.push_back(sentence(name, "none", value));
    return found;
}

/// The first words of a list that another one lacks.
std::string onlyIn(const std::string& list, const std::string& other) {
    constexpr size_t most = 5;
    const std::vector<std::string> known = split(other, ' ');
    std::vector<std::string> words = split(list, ' ');
    std::erase_if(words, [&](const std::string& word) { return std::ranges::count(known, word) > 0; });
    if (words.size() > most) { words.resize(most); words.push_back("..."); }
    return words.empty() ? "nothing" : fmt::format("{}", fmt::join(words, " "));
}

}  // namespace

RenderIdentity identityOf(const Session& session, const SessionOptions& options, const Film& film) {
    RenderIdentity identity{settingsOf(session, options, film), partOf(film),
                            tablesOf(session.packed()),         {},
                            session.deviceNames(),    session.packed().samples};
    for (const std::string& file : inputFiles()) identity.files.emplace_back(file, contentHash(file));
    return identity;
}

std::string toJson(const RenderIdentity& identity) {
    const Json json{{"settings", asJson(identity.settings)},
                    {"part", asJson(identity.part)},
                    {"scene", asJson(identity.tables)},
                    {"files", asJson(identity.files)},
                    {"device", identity.device},
                    {"samples", identity.samples}};
    return jsonText(json, 1);
}

RenderIdentity identityFromJson(const std::string& text, const std::string& name) {
    try {
        const Json json = Json::parse(text);
        return {valuesFrom(json.at("settings")), valuesFrom(json.at("part")), valuesFrom(json.at("scene")), valuesFrom(json.at("files")),
                json.at("device").get<std::string>(), json.at("samples").get<int>()};
    } catch (const Json::exception& error) {
        throw Error(ExitCode::scene, fmt::format("{}: is damaged: {}", name, error.what()));
    }
}

std::vector<std::string> partDifferences(const RenderIdentity& here, const RenderIdentity& there, const std::string& name) {
    std::vector<std::string> found = compare(here.settings, there.settings, [&](auto&& what, auto&& value, auto&& other) {
        if (what == keptOfPixels)
            return fmt::format("{} (by --aov, --fireflies and others): only here {}; only in {} {}", what, onlyIn(value, other), name,
                               onlyIn(other, value));
        return fmt::format("{} is \"{}\" here and \"{}\" in {}", what, value, other, name);
    });
    if (here.samples != there.samples)
        found.push_back(fmt::format("samples per pixel: {} here and {} in {}", here.samples, there.samples, name));
    const std::vector<std::string> tables = compare(here.tables, there.tables, [&](auto&& what, auto&& value, auto&& other) {
        return fmt::format("{} of the scene: hash {} here, {} in {}", what, value, other, name);
    });
    if (tables.empty()) return found;
    const std::vector<std::string> files = compare(here.files, there.files, [&](auto&& what, auto&& value, auto&& other) {
        return fmt::format("file \"{}\": content has hash {} here, {} in {}", what, value, other, name);
    });
    found.insert(found.end(), files.begin(), files.end());
    return found.empty() ? tables : found;
}

std::vector<std::string> differences(const RenderIdentity& here, const RenderIdentity& there, const std::string& name) {
    std::vector<std::string> found = partDifferences(here, there, name);
    const std::vector<std::string> part = compare(here.part, there.part, [&](auto&& what, auto&& value, auto&& other) {
        return fmt::format("{} is \"{}\" here and \"{}\" in {}", what, value, other, name);
    });
    found.insert(found.end(), part.begin(), part.end());
    return found;
}

}  // namespace eikonal
