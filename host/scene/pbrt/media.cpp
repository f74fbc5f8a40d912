#include "scene/pbrt/media.h"

#include "scene/pbrt/medium_presets.h"

#include <fmt/format.h>

#include <utility>

namespace eikonal::pbrt {
namespace {

enum MediumKindOfPbrt { homogeneousKind, uniformGridKind, otherKind };

constexpr const char* gridParameters =
    "point3 p0; point3 p1; float g = 0; spectrum sigma_a = 1; spectrum sigma_s = 1; float scale = 1; integer nx = 1; integer ny = 1;"
    "integer nz = 1; spectrum Le = 0; floats Lescale; floats density; floats temperature; float temperatureoffset = 0;"
    "float temperaturecutoff = 0; float temperaturescale = 1";

/// Values on the grid that a medium describes; empty if the parameter is not given. Throws SceneError.
Grid readGrid(const Arguments& arguments, const std::string& name) {
    Grid grid;
    grid.nx = arguments.integer("nx");
    grid.ny = arguments.integer("ny");
    grid.nz = arguments.integer("nz");
    if (grid.nx < 1 || grid.ny < 1 || grid.nz < 1) throw SceneError(arguments.where(), "the grid's nx, ny and nz must be at least 1");
    const std::vector<double> values = arguments.numbers(name);
    const double expected = double(grid.nx) * grid.ny * grid.nz;
    if (!values.empty() && static_cast<double>(values.size()) != expected)
        throw SceneError(arguments.whereOf(name), fmt::format("\"float {}\" has {} values; nx * ny * nz = {} * {} * {} = {:.0f} are expected", name,
                                                              values.size(), grid.nx, grid.ny, grid.nz, expected));
    grid.values.assign(values.begin(), values.end());
    return grid;
}

void readHomogeneous(Reading& reading, const Arguments& arguments, Medium& medium) {
    medium.kind = MediumKind::homogeneous;
    if (const std::string preset = arguments.text("preset"); !preset.empty()) {
        const MediumPreset* measured = mediumPreset(preset);
        if (measured) {
            medium.sigmaA = Spectrum::rgb(measured->sigmaA);
            medium.sigmaS = Spectrum::rgb(measured->reducedSigmaS);
        } else {
            const std::string near = nearestWord(preset, mediumPresetNames());
            reading.unsupported("preset " + preset, arguments.whereOf("preset"),
                                "there is no preset \"" + preset + "\"" + (near.empty() ? "" : "; did you mean \"" + near + "\"?") +
                                    " (sigma_a and sigma_s count instead)");
        }
    }
    const double scale = arguments.number("scale");
    medium.sigmaA = medium.sigmaA * scale;
    medium.sigmaS = medium.sigmaS * scale;
    medium.Le = arguments.spectrum("Le") * arguments.number("Lescale");
}

void readUniformGrid(Reading& reading, const Arguments& arguments, Medium& medium) {
    medium.kind = MediumKind::uniformGrid;
    medium.density = readGrid(arguments, "density");
    if (medium.density.values.empty()) throw SceneError(arguments.where(), "medium \"uniformgrid\" needs \"float density\"");
    medium.LeScale = readGrid(arguments, "Lescale");
    medium.p0 = arguments.vector("p0", glm::dvec3(0));
    medium.p1 = arguments.vector("p1", glm::dvec3(1));
    medium.sigmaA = medium.sigmaA * arguments.number("scale");
    medium.sigmaS = medium.sigmaS * arguments.number("scale");
    medium.Le = arguments.spectrum("Le");
    if (arguments.has("temperature"))
        reading.unsupported("medium temperature", arguments.whereOf("temperature"), "glow by temperature is not rendered yet; the medium does not emit");
}

}  // namespace

const KindTable& mediumKinds() {
    static const KindTable table("medium", "string type", {
        {"homogeneous", homogeneousKind,
         "string preset; spectrum sigma_a = 1; spectrum sigma_s = 1; float scale = 1; spectrum Le = 0; float Lescale = 1; float g = 0"},
        {"uniformgrid", uniformGridKind, gridParameters},
        {"rgbgrid", otherKind,
         "integer nx = 1; integer ny = 1; integer nz = 1; spectrum sigma_a; spectrum sigma_s; spectrum Le; float Lescale = 1; float scale = 1;"
         "float g = 0; point3 p0; point3 p1", "it is empty"},
        {"cloud", otherKind,
         "float density = 1; float g = 0; float wispiness = 1; float frequency = 5; spectrum sigma_a = 1; spectrum sigma_s = 1; point3 p0; point3 p1",
         "it is empty"},
        {"nanovdb", otherKind,
         "file filename; string gridname; string temperaturename; float Lescale = 1; float temperatureoffset = 0; float temperaturecutoff = 0;"
         "float temperaturescale = 1; float g = 0; spectrum sigma_a = 1; spectrum sigma_s = 1; float scale = 1", "it is empty"},
    });
    return table;
}

int MediumBook::numberOf(const std::string& name) {
    if (name.empty()) return none;
    const auto [place, isNew] = numbers_.try_emplace(name, static_cast<int>(entries_.size()));
    if (isNew) entries_.push_back({name});
    return place->second;
}

void MediumBook::define(const std::string& name, const GraphicsState& state, ParameterList parameters, const SourceLocation& where) {
    const int number = numberOf(name);
    if (number == none) throw SceneError(where, "a medium needs a name; \"\" means vacuum");
    if (entries_[number].made) throw SceneError(where, "there is already a medium \"" + name + "\", at " + entries_[number].where.toString());
    entries_[number].made = true;
    entries_[number].where = where;

    const Kind& kind = mediumKinds().find(typeOf(parameters, "MakeNamedMedium", where), where);
    const Arguments arguments(reading_, kind, where, std::move(parameters), state.attributesOf(Target::medium), state.space);
    if (kind.standIn) {
        reading_.unsupported(kind.title(), where, kind.title() + " is not rendered yet; " + kind.standIn);
        return;
    }
    Medium medium;
    medium.name = name;
    medium.where = where;
    medium.worldFromMedium = state.transform[0];
    medium.sigmaA = arguments.spectrum("sigma_a");
    medium.sigmaS = arguments.spectrum("sigma_s");
    medium.g = arguments.number("g");
    if (kind.value == homogeneousKind) readHomogeneous(reading_, arguments, medium);
    else readUniformGrid(reading_, arguments, medium);
    entries_[number].index = static_cast<int>(reading_.scene.media.size());
    reading_.scene.media.push_back(std::move(medium));
}

int MediumBook::resolve(int number, const SourceLocation& where) {
    if (number == none) return none;
    Entry& entry = entries_[number];
    if (!entry.made && !std::exchange(entry.missed, true)) {
        std::vector<std::string> names;
        for (const Entry& other : entries_)
            if (other.made) names.push_back(other.name);
        const std::string near = nearestWord(entry.name, names);
        reading_.problems.add(where, "there is no medium \"" + entry.name + "\"" + (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
    }
    return entry.index;
}

}  // namespace eikonal::pbrt
