#include "unit/pbrt_kind_scenes.h"

#include "image/image_file.h"
#include "measured_file.h"
#include "nanovdb_file.h"
#include "read/pbrt/lights.h"
#include "read/pbrt/materials.h"
#include "read/pbrt/media.h"
#include "read/pbrt/setting_kinds.h"
#include "read/pbrt/shapes.h"
#include "read/pbrt/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>

namespace eikonal::pbrt {
namespace {

/// Parameters by name, with their values.
using Declarations = std::map<std::string, std::string>;

/// What kinds cannot do without, by their titles.
Declarations requiredBy(const std::string& title) {
    static const std::map<std::string, Declarations> all = {
        {"camera \"realistic\"", {{"lensfile", "\"string lensfile\" \"lens.dat\""}}},
        {"light \"goniometric\"", {{"filename", "\"string filename\" \"square.pfm\""}}},
        {"light \"projection\"", {{"filename", "\"string filename\" \"square.pfm\""}}},
        {"shape \"trianglemesh\"", {{"P", "\"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 1]"}, {"indices", "\"integer indices\" [0 1 2 1 2 3]"}}},
        {"shape \"bilinearmesh\"", {{"P", "\"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 1]"}, {"indices", "\"integer indices\" [0 1 2 3]"}}},
        {"shape \"loopsubdiv\"", {{"P", "\"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 1]"}, {"indices", "\"integer indices\" [0 1 2 1 3 2]"}}},
        {"shape \"plymesh\"", {{"filename", "\"string filename\" \"a.ply\""}}},
        {"shape \"curve\"", {{"P", "\"point3 P\" [0 0 0 1 0 0 1 1 0 2 1 1 3 0 0 3 1 0 4 1 0]"}}},
        {"shape \"implicit\"",
         {{"F", "\"string F\" \"a*x^2 + b*y^2 + c*z^2 - d\""},
          {"bounds", "\"point3 bounds\" [-1 -1 -1 1 1 1]"},
          {"a", "\"float a\" 2"},
          {"b", "\"float b\" 2"},
          {"c", "\"float c\" 2"},
          {"d", "\"float d\" 1"}}},
        {"material \"mix\"", {{"materials", "\"string materials\" [\"red\" \"metal\"]"}}},
        {"material \"measured\"", {{"filename", "\"string filename\" \"a.bsdf\""}}},
        {"texture \"imagemap\"", {{"filename", "\"string filename\" \"square.png\""}}},
        {"medium \"nanovdb\"", {{"filename", "\"string filename\" \"a.nvdb\""}}},
        {"medium \"uniformgrid\"", {{"density", "\"float density\" [1 .5]"}, {"nx", "\"integer nx\" 2"}}},
        {"medium \"rgbgrid\"",
         {{"sigma_a", "\"rgb sigma_a\" [1 1 1 .5 .5 .5]"}, {"sigma_s", "\"rgb sigma_s\" [1 1 1 .5 .5 .5]"}, {"nx", "\"integer nx\" 2"}}},
    };
    const auto found = all.find(title);
    return found == all.end() ? Declarations() : found->second;
}

/// Values for parameters whose form depends on the kind, by title and name, or by name for all kinds.
std::vector<std::string> formedValues(const std::string& title, const std::string& name) {
    static const std::map<std::string, std::vector<std::string>> all = {
        {"screenwindow", {"\"float screenwindow\" [-1 2 -1 1]"}},
        {"cropwindow", {"\"float cropwindow\" [0 .5 0 1]"}},
        {"pixelbounds", {"\"integer pixelbounds\" [0 2 0 3]"}},
        {"lensfile", {"\"string lensfile\" \"other.dat\""}},
        {"aperture", {"\"string aperture\" \"square\"", "\"string aperture\" \"other.pfm\""}},
        {"sensor", {"\"string sensor\" \"nikon_d850\""}},
        {"whitebalance", {"\"float whitebalance\" 5000"}},
        {"lambdamin", {"\"float lambdamin\" 400"}},
        {"lambdamax", {"\"float lambdamax\" 700"}},
        {"portal", {"\"point3 portal\" [0 0 2 1 0 2 1 1 2 0 1 2]"}},
        {"indices", {"\"integer indices\" [2 1 3 0]", "\"integer indices\" [3 2 1]"}},
        {"faceIndices", {"\"integer faceIndices\" [7 8]"}},
        {"P", {"\"point3 P\" [0 0 0 1 0 0 0 2 0 1 1 1]", "\"point3 P\" [0 0 0 1 0 0 1 2 0 2 1 1]"}},
        {"uv", {"\"point2 uv\" [0 0 1 0 0 1 .5 .5]"}},
        {"bounds", {"\"point3 bounds\" [-1 -1 -1 1 1 2]"}},
        {"F", {"\"string F\" \"a*x^2 + b*y^2 + c*z^4 - d*1\""}},
        {"materials", {"\"string materials\" [\"metal\" \"red\"]"}},
        {"name", {"\"string name\" \"Skimmilk\""}},
        {"lightgroup", {"\"string lightgroup\" \"key\""}},
        {"preset", {"\"string preset\" \"Skimmilk\""}},
        {"encoding", {"\"string encoding\" \"linear\"", "\"string encoding\" \"gamma 1.4\""}},
        {"normalmap", {"\"string normalmap\" \"other.png\""}},
        {"bsdf", {"\"string filename\" \"other.bsdf\""}},
        {"gridname", {"\"string gridname\" \"temperature\""}},
        {"temperaturename", {"\"string temperaturename\" \"density\""}},
        {"density", {"\"float density\" [.7 .5]", "\"float density\" .5"}},
        {"temperature", {"\"float temperature\" [4000 3000]"}},
        {"Lescale", {"\"float Lescale\" [2 3]", "\"float Lescale\" 2"}},
        {"levels", {"\"integer levels\" 1"}},
        {"dimension", {"\"integer dimension\" 3"}},
        {"S", {"\"vector3 S\" [1 0 0 1 0 0 0 1 0 1 1 0]"}},
        {"type", {"\"string type\" \"homogeneous\"", "\"string type\" \"cloud\""}},
        {"N", {"\"normal N\" [0 0 1 0 1 1 0 1 0 1 1 0]"}},
        {"medium \"rgbgrid\" type",
         {"\"string type\" \"uniformgrid\" \"float density\" [1 .5] \"rgb sigma_a\" [1 1 1] \"rgb sigma_s\" [1 1 1]"}},
        {"shape \"curve\" N", {"\"normal N\" [0 0 1 0 1 1 1 0 0]", "\"normal N\" [0 0 1 0 1 0 1 0 0]"}},
        {"medium \"uniformgrid\" nx", {"\"integer nx\" 1 \"integer ny\" 2"}},
        {"medium \"uniformgrid\" ny", {"\"integer ny\" 2 \"integer nx\" 1"}},
        {"medium \"uniformgrid\" nz", {"\"integer nz\" 2 \"integer nx\" 1"}},
        {"medium \"rgbgrid\" nx", {"\"integer nx\" 1 \"integer ny\" 2"}},
        {"medium \"rgbgrid\" ny", {"\"integer ny\" 2 \"integer nx\" 1"}},
        {"medium \"rgbgrid\" nz", {"\"integer nz\" 2 \"integer nx\" 1"}},
        {"function", {"\"string function\" \"linear\""}},
        {"imagefilename", {"\"string imagefilename\" \"a.exr\""}},
        {"emissionfilename", {"\"string emissionfilename\" \"square.pfm\""}},
        {"msereferenceimage", {"\"string msereferenceimage\" \"square.pfm\""}},
        {"msereferenceout", {"\"string msereferenceout\" \"mse.txt\""}},
        {"light \"goniometric\" filename", {"\"string filename\" \"other.pfm\""}},
        {"light \"projection\" filename", {"\"string filename\" \"other.pfm\""}},
        {"light \"infinite\" filename", {"\"string filename\" \"square.pfm\""}},
        {"area light \"diffuse\" filename", {"\"string filename\" \"square.pfm\""}},
        {"texture \"imagemap\" filename", {"\"string filename\" \"other.png\""}},
        {"texture \"ptex\" filename", {"\"string filename\" \"a.ptx\""}},
        {"shape \"plymesh\" filename", {"\"string filename\" \"other.ply\""}},
        {"material \"measured\" filename", {"\"string filename\" \"other.bsdf\""}},
        {"medium \"nanovdb\" filename", {"\"string filename\" \"other.nvdb\""}},
        {"medium \"rgbgrid\" sigma_a", {"\"rgb sigma_a\" [.1 .2 .3 .4 .5 .6]"}},
        {"medium \"rgbgrid\" sigma_s", {"\"rgb sigma_s\" [.1 .2 .3 .4 .5 .6]"}},
        {"medium \"rgbgrid\" Le", {"\"rgb Le\" [.1 .2 .3 .4 .5 .6]"}},
        {"medium \"cloud\" density", {"\"float density\" .5"}},
        {"filename", {"\"string filename\" \"named.exr\""}},
    };
    for (const std::string& key : {title + " " + name, name})
        if (const auto found = all.find(key); found != all.end()) return found->second;
    return {};
}

/// What else must be given, by noun, kind and name: "*" for all nouns or kinds.
struct Companion {
    const char *noun, *kind, *name, *given;
};
constexpr Companion companions[] = {
    {"texture", "*", "v1", "\"string mapping\" \"planar\""},
    {"texture", "*", "v2", "\"string mapping\" \"planar\""},
    {"camera", "*", "focaldistance", "\"float lensradius\" .1"},
    {"shape", "curve", "N", "\"string type\" \"ribbon\""},
    {"shape", "plymesh", "edgelength", "\"texture displacement\" \"bumps\""},
    {"medium", "homogeneous", "Lescale", "\"rgb Le\" [1 1 1]"},
    {"medium", "uniformgrid", "Lescale", "\"rgb Le\" [1 1 1]"},
    {"medium", "rgbgrid", "Lescale", "\"rgb Le\" [1 1 1 2 2 2]"},
    {"medium", "uniformgrid", "temperaturecutoff", "\"float temperature\" [4000 3000]"},
    {"medium", "uniformgrid", "temperatureoffset", "\"float temperature\" [4000 3000]"},
    {"medium", "uniformgrid", "temperaturescale", "\"float temperature\" [4000 3000]"},
    {"material", "subsurface", "mfp", "\"rgb reflectance\" [.5 .5 .5]"},
    {"material", "subsurface", "sigma_a", "\"rgb sigma_s\" [.5 .5 .5]"},
    {"material", "subsurface", "sigma_s", "\"rgb sigma_a\" [.5 .5 .5]"},
    {"material", "*", "remaproughness", "\"float roughness\" .3"},
    {"material", "coatedconductor", "remaproughness", "\"float conductor.roughness\" .3"},
    {"material", "*", "energycompensation", "\"float roughness\" .5"},
    {"material", "coateddiffuse", "g", "\"rgb albedo\" [.5 .5 .5]"},
    {"material", "coatedconductor", "g", "\"rgb albedo\" [.5 .5 .5]"},
    {"option", "*", "msereferenceimage", "Option \"msereferenceout\" \"mse.txt\""},
    {"option", "*", "msereferenceout", "Option \"msereferenceimage\" \"square.pfm\""},
    {"light", "infinite", "illuminance", "\"string filename\" \"square.pfm\""},
};

constexpr const char* world = R"(WorldBegin
MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [.7 .2 .1]
MakeNamedMaterial "metal" "string type" "conductor"
Texture "bumps" "float" "wrinkled"
LightSource "point" "point3 from" [0 0 -3]
LightSource "point" "point3 from" [0 3 -3] "rgb I" [5 5 5]
Material "conductor" "float roughness" .1
Shape "sphere" "float radius" .5
)";
constexpr const char* film = "Film \"rgb\" \"integer xresolution\" 4 \"integer yresolution\" 4\n";

void add(std::vector<KindInPlace>& all, const KindTable& table, const std::string& head, const std::string& before,
         const std::string& after) {
    for (const Kind& kind : table.kinds()) all.push_back({&kind, head + " \"" + kind.name + "\"", before, after});
}

void writePattern(const std::string& path, float step) {
    FilmImage image(4, 4);
    for (int i = 0; i < 48; ++i) image.color[static_cast<size_t>(i / 3)][i % 3] = 0.1f + step * static_cast<float>(i % 7);
    writeImage(path, image, {});
}

void writeMesh(const std::string& path, double height) {
    std::ofstream(path) << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                           "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
                        << height << "\n3 0 1 2\n";
}

}  // namespace

std::string KindInPlace::scene(const std::string& given) const {
    std::string required;
    for (const auto& [name, declaration] : requiredBy(kind->title()))
        if (given.find(' ' + name + '"') == given.npos) required += ' ' + declaration;
    return before + directive + ' ' + given + required + '\n' + after;
}

int KindInPlace::line() const { return 1 + static_cast<int>(std::ranges::count(before, '\n')); }

std::vector<KindInPlace> allKinds() {
    std::vector<KindInPlace> all;
    const char* const settings[] = {"Camera", "Film", "PixelFilter", "Sampler", "Integrator", "Accelerator"};
    const std::vector<const KindTable*> tables = settingKinds();
    for (size_t i = 0; i < tables.size(); ++i) add(all, *tables[i], settings[i], settings[i] == std::string("Film") ? "" : film, world);
    add(all, optionKinds(), "Option", film,
        world + std::string("Shape \"plymesh\" \"string filename\" \"a.ply\" ") + "\"texture displacement\" \"bumps\"\n");
    const std::string begin = film + std::string(world), sphere = "Shape \"sphere\"\n";
    add(all, lightKinds(), "LightSource", begin, "");
    add(all, areaLightKinds(), "AreaLightSource", begin, sphere);
    add(all, shapeKinds(), "Shape", begin, "");
    const KindTable& materials = materialKinds();
    for (const Kind& kind : materials.kinds()) all.push_back({&kind, "Material \"" + kind.name + "\"", begin, sphere});
    add(all, textureKinds(true), "Texture \"t\" \"float\"", begin, "Material \"conductor\" \"texture roughness\" \"t\"\n" + sphere);
    add(all, textureKinds(false), "Texture \"t\" \"spectrum\"", begin, "Material \"diffuse\" \"texture reflectance\" \"t\"\n" + sphere);
    for (const Kind& kind : mediumKinds().kinds())
        all.push_back({&kind, "MakeNamedMedium \"m\" \"string type\" \"" + kind.name + "\"", begin,
                       "MediumInterface \"m\" \"\"\nMaterial \"interface\"\n" + sphere});
    return all;
}

std::vector<std::string> otherValues(const KindInPlace& place, const Rule& rule, const std::string& name) {
    if (std::vector<std::string> formed = formedValues(place.kind->title(), name); !formed.empty() && rule.choices.empty()) return formed;
    std::vector<std::string> values;
    const auto declare = [&](const char* type, const std::string& value) {
        values.push_back(fmt::format("\"{} {}\" {}", type, name, value));
    };
    const auto numbers = [&](const char* type, std::initializer_list<double> candidates) {
        for (const double x : candidates)
            if ((!rule.range || rule.range->holds(x)) && rule.fallback != fmt::format("{:g}", x)) declare(type, fmt::format("{:g}", x));
    };
    switch (rule.wanted) {
        case Wanted::flag:
            declare("bool", rule.fallback == "true" ? "false" : "true");
            break;
        case Wanted::floatMap:
            declare("texture", "\"bumps\"");
            [[fallthrough]];
        case Wanted::number:
            numbers("float", {0.3, 0.7, 2.5, 40, 600});
            break;
        case Wanted::index:
            numbers("float", {1.7});
            break;
        case Wanted::integer:
            numbers("integer", {1, 2, 7, 0});
            break;
        case Wanted::colorMap:
        case Wanted::spectrumMap:
        case Wanted::spectrum:
            declare("rgb", "[.2 .4 .6]");
            declare("rgb", "[.1 .2 .3]");
            break;
        case Wanted::point3:
            declare("point3", "[.3 .2 .1]");
            break;
        case Wanted::vector3:
            declare("vector3", "[.3 .5 .7]");
            break;
        case Wanted::floatTexture:
            declare("texture", "\"bumps\"");
            break;
        default:
            break;
    }
    for (const std::string& choice : rule.choices)
        if (choice != rule.fallback) declare("string", '"' + choice + '"');
    return values;
}

std::string companionOf(const KindInPlace& place, const std::string& name) {
    const auto matches = [](const char* pattern, const std::string& text) { return pattern == std::string("*") || pattern == text; };
    std::string given;
    for (const Companion& c : companions)
        if (matches(c.noun, place.kind->noun) && matches(c.kind, place.kind->name) && name == c.name) given = ' ' + std::string(c.given);
    return given;
}

std::string anyValue(ParameterType type, const std::string& name) {
    using T = ParameterType;
    const std::string value = type == T::boolean                        ? "true"
                              : type == T::text || type == T::texture   ? "\"x\""
                              : type == T::number || type == T::integer ? "1"
                              : type == T::blackbody                    ? "3000"
                              : type == T::point2 || type == T::vector2 ? "[1 1]"
                              : type == T::spectrum                     ? "[400 1 700 1]"
                                                                        : "[1 1 1]";
    return fmt::format("\"{} {}\" {}", nameOf(type), name, value);
}

void writeFilesOfScenes(const std::string& folder) {
    const auto path = [&](const char* name) { return folder + '/' + name; };
    std::ofstream(path("lens.dat")) << "35 4 1.5 20\n-35 20 1 20\n0 2 0 10\n";
    std::ofstream(path("other.dat")) << "30 4 1.5 20\n-35 20 1 20\n0 2 0 10\n";
    writePattern(path("square.pfm"), 0.1f);
    writePattern(path("other.pfm"), 0.2f);
    writePattern(path("square.png"), 0.1f);
    writePattern(path("other.png"), 0.12f);
    MeasuredFile{}.write(path("a.bsdf"));
    MeasuredFile{.alpha = 0.3}.write(path("other.bsdf"));
    const auto grid = [](const char* name, float value) {
        return TestGrid{.name = name, .half = 2, .value = [=](int x, int, int) { return value + static_cast<float>(x); }};
    };
    writeNanoVdb(path("a.nvdb"), {grid("density", 3), grid("temperature", 3000)});
    writeNanoVdb(path("other.nvdb"), {grid("density", 4), grid("temperature", 3000)});
    writeMesh(path("a.ply"), 0);
    writeMesh(path("other.ply"), 1);
}

}  // namespace eikonal::pbrt
