#include "read/pbrt/media.h"

#include "read/formats/nanovdb.h"
#include "read/pbrt/medium_presets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace eikonal::pbrt {
namespace {

enum MediumKindOfPbrt { homogeneousKind, uniformGridKind, rgbGridKind, cloudKind, nanoVdbKind };

constexpr const char* glow = "float temperaturecutoff = 0; float temperatureoffset | temperaturecutoff = 0; float temperaturescale = 1;";

/// The dimensions of a medium's grid. Throws SceneError.
glm::ivec3 readSize(const Arguments& arguments) {
    const glm::ivec3 size(arguments.integer("nx"), arguments.integer("ny"), arguments.integer("nz"));
    if (size.x < 1 || size.y < 1 || size.z < 1) throw SceneError(arguments.where(), "the grid's nx, ny and nz must be at least 1");
    return size;
}

/// Throws SceneError unless there is one value per grid cell.
void checkCount(const Arguments& arguments, const std::string& name, size_t count, glm::ivec3 size, const char* type) {
    const double expected = double(size.x) * size.y * size.z;
    if (static_cast<double>(count) != expected)
        throw SceneError(arguments.whereOf(name), fmt::format("\"{} {}\" has {} values; nx * ny * nz = {} * {} * {} = {:.0f} are expected", type, name, count,
                                                              size.x, size.y, size.z, expected));
}

/// The values of a medium's grid, not negative; empty if the parameter is not given. Throws SceneError.
Grid readGrid(const Arguments& arguments, const std::string& name) {
    const glm::ivec3 size = readSize(arguments);
    const std::vector<double> values = arguments.numbers(name);
    if (!values.empty()) checkCount(arguments, name, values.size(), size, "float");
    const auto below = std::ranges::find_if(values, [](double value) { return value < 0; });
    if (below != values.end()) throw SceneError(arguments.whereOf(name), fmt::format("\"float {}\" has a value below 0: {:g}", name, *below));
    return {size.x, size.y, size.z, {values.begin(), values.end()}};
}

std::vector<glm::vec3> readColors(const Arguments& arguments, const std::string& name) {
    std::vector<glm::vec3> colors = arguments.colors(name);
    if (!colors.empty()) checkCount(arguments, name, colors.size(), readSize(arguments), "rgb");
    return colors;
}

void readBox(const Arguments& arguments, Medium& medium) {
    medium.p0 = arguments.vector("p0", glm::dvec3(0));
    medium.p1 = arguments.vector("p1", glm::dvec3(1));
    const glm::dvec3 low = glm::min(medium.p0, medium.p1);
    medium.p1 = glm::max(medium.p0, medium.p1);
    medium.p0 = low;
    if (glm::any(glm::equal(medium.p0, medium.p1))) throw SceneError(arguments.where(), "the medium's box from \"p0\" to \"p1\" is flat");
}

void readCoefficients(const Arguments& arguments, Medium& medium) {
    medium.sigmaA = arguments.spectrum("sigma_a");
    medium.sigmaS = arguments.spectrum("sigma_s");
}

void readGlow(const Arguments& arguments, Medium& medium) {
    medium.temperatureOffset = arguments.number("temperatureoffset");
    medium.temperatureScale = arguments.number("temperaturescale");
}

void readHomogeneous(Reading& reading, const Arguments& arguments, Medium& medium) {
    medium.kind = MediumKind::homogeneous;
    readCoefficients(arguments, medium);
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

void readUniformGrid(const Arguments& arguments, Medium& medium) {
    medium.kind = MediumKind::uniformGrid;
    readCoefficients(arguments, medium);
    medium.density = readGrid(arguments, "density");
    if (medium.density.values.empty()) throw SceneError(arguments.where(), "medium \"uniformgrid\" needs \"float density\"");
    medium.temperature = readGrid(arguments, "temperature");
    if (arguments.has("Le") && arguments.has("temperature"))
        throw SceneError(arguments.whereOf("Le"), "the medium has both \"Le\" and \"temperature\"; give one of them");
    /* If it is not given, pbrt-v4 uses a grid of a single 1, which falls off towards the sides */
    medium.LeScale = readGrid(arguments, "Lescale");
    if (medium.LeScale.values.empty()) medium.LeScale = {1, 1, 1, {1}};
    readBox(arguments, medium);
    medium.sigmaA = medium.sigmaA * arguments.number("scale");
    medium.sigmaS = medium.sigmaS * arguments.number("scale");
    medium.Le = arguments.spectrum("Le");
    readGlow(arguments, medium);
}

void readRgbGrid(const Arguments& arguments, Medium& medium) {
    medium.kind = MediumKind::rgbGrid;
    const glm::ivec3 size = readSize(arguments);
    medium.colors = {size.x, size.y, size.z, readColors(arguments, "sigma_a"), readColors(arguments, "sigma_s"), readColors(arguments, "Le"), arguments.space()};
    if (medium.colors.sigmaA.empty() && medium.colors.sigmaS.empty())
        throw SceneError(arguments.where(), "medium \"rgbgrid\" needs \"rgb sigma_a\" or \"rgb sigma_s\"");
    if (!medium.colors.Le.empty() && medium.colors.sigmaA.empty()) throw SceneError(arguments.whereOf("Le"), "an emitting medium must absorb: \"rgb Le\" needs \"rgb sigma_a\"");
    readBox(arguments, medium);
    medium.sigmaA = medium.sigmaS = Spectrum::constant(arguments.number("scale"));
    /* pbrt-v4 does not divide these by the luminance of white, unlike the emission of lights */
    medium.emissionScale = arguments.number("Lescale") * integrateXyz(whiteSpectrum(arguments.space())).y;
}

void readCloud(const Arguments& arguments, Medium& medium) {
    medium.kind = MediumKind::cloud;
    readCoefficients(arguments, medium);
    readBox(arguments, medium);
    medium.cloudDensity = arguments.number("density");
    medium.wispiness = arguments.number("wispiness");
    medium.frequency = arguments.number("frequency");
}

void readNanoVdbMedium(const Arguments& arguments, Medium& medium) {
    medium.kind = MediumKind::nanovdb;
    readCoefficients(arguments, medium);
    medium.sigmaA = medium.sigmaA * arguments.number("scale");
    medium.sigmaS = medium.sigmaS * arguments.number("scale");
    if (!arguments.has("filename")) throw SceneError(arguments.where(), "medium \"nanovdb\" needs a \"string filename\"");
    const std::optional<std::string> path = arguments.file("filename");
    if (!path) return;
    try {
        medium.sparseDensity = readNanoVdb(*path, arguments.text("gridname"));
        medium.sparseTemperature = readNanoVdb(*path, arguments.text("temperaturename"));
        if (!medium.sparseDensity)
            throw SceneError(arguments.whereOf("gridname"), fmt::format("{} has no grid \"{}\"; it has \"{}\"", *path, arguments.text("gridname"), fmt::join(gridNames(*path), "\", \"")));
        if (!medium.sparseTemperature && arguments.has("temperaturename"))
            throw SceneError(arguments.whereOf("temperaturename"), fmt::format("{} has no grid \"{}\"; it has \"{}\"", *path, arguments.text("temperaturename"), fmt::join(gridNames(*path), "\", \"")));
    } catch (const ReadProblem& problem) {
        throw SceneError(arguments.whereOf("filename"), *path + " " + problem.what());
    }
    medium.emissionScale = arguments.number("Lescale");
    readGlow(arguments, medium);
}

}  // namespace

const KindTable& mediumKinds() {
    static const std::string coefficients = "float g = 0 clamped to [-1, 1]; spectrum sigma_a = 1; spectrum sigma_s = 1;", box = "point3 p0; point3 p1;",
                             size = "integer nx = 1; integer ny = 1; integer nz = 1;";
    static const std::string uniformGrid = coefficients + box + size + glow + "float scale = 1 in [0, inf); spectrum Le = 0; floats Lescale; floats density; floats temperature";
    static const std::string rgbGrid = box + size + "colors sigma_a; colors sigma_s; colors Le; float Lescale = 1 in [0, inf); float scale = 1 in [0, inf); float g = 0 clamped to [-1, 1]";
    static const std::string cloud = coefficients + box + "float density = 1 in [0, inf); float wispiness = 1; float frequency = 5";
    static const std::string nanoVdb = coefficients + glow + "file filename; string gridname = density; string temperaturename = temperature; float Lescale = 1 in [0, inf);"
                                       "float scale = 1 in [0, inf)";
    static const KindTable table("medium", "string type", {
        {"homogeneous", homogeneousKind,
         "string preset; spectrum sigma_a = 1; spectrum sigma_s = 1; float scale = 1 in [0, inf); spectrum Le = 0; float Lescale = 1 in [0, inf);"
         "float g = 0 clamped to [-1, 1]"},
        {"uniformgrid", uniformGridKind, uniformGrid.c_str()},
        {"rgbgrid", rgbGridKind, rgbGrid.c_str()},
        {"cloud", cloudKind, cloud.c_str()},
        {"nanovdb", nanoVdbKind, nanoVdb.c_str()},
    });
    return table;
}

int MediumRegistry::numberOf(const std::string& name) {
    if (name.empty()) return none;
    const auto [place, isNew] = numbers_.try_emplace(name, static_cast<int>(entries_.size()));
    if (isNew) entries_.push_back({name});
    return place->second;
}

void MediumRegistry::define(const std::string& name, const GraphicsState& state, ParameterList parameters, const SourceLocation& where) {
    const int number = numberOf(name);
    if (number == none) throw SceneError(where, "a medium needs a name; \"\" means vacuum");
    if (entries_[number].made) throw SceneError(where, "there is already a medium \"" + name + "\", at " + entries_[number].where.toString());
    entries_[number].made = true;
    entries_[number].where = where;

    const Kind& kind = mediumKinds().find(typeOf(parameters, "MakeNamedMedium", where), where);
    const Arguments arguments(reading_, kind, where, std::move(parameters), state.attributesOf(Target::medium), state.space);
    Medium medium;
    medium.name = name;
    medium.where = where;
    medium.worldFromMedium = state.transform[0];
    medium.g = arguments.number("g");
    switch (kind.value) {
        case homogeneousKind: readHomogeneous(reading_, arguments, medium); break;
        case uniformGridKind: readUniformGrid(arguments, medium); break;
        case rgbGridKind: readRgbGrid(arguments, medium); break;
        case cloudKind: readCloud(arguments, medium); break;
        default: readNanoVdbMedium(arguments, medium);
    }
    if (glm::determinant(glm::dmat3(medium.worldFromMedium)) == 0 && kind.value != homogeneousKind)
        throw SceneError(where, "the medium's transform cannot be inverted; is there a Scale of 0?");
    if (medium.kind == MediumKind::nanovdb && !medium.sparseDensity) return;   // its missing file is already noted
    entries_[number].index = static_cast<int>(reading_.scene.media.size());
    reading_.scene.media.push_back(std::move(medium));
}

int MediumRegistry::resolve(int number, const SourceLocation& where) {
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
