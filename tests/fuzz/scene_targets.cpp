// Scenes and the files of one format that a scene names.

#include "targets.h"

#include "diagnostics.h"
#include "nanovdb_file.h"
#include "pack/pack.h"
#include "read/formats/expression.h"
#include "read/obj/obj.h"
#include "read/pbrt/read_pbrt.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace eikonal::fuzz {
namespace {

/// Whether errors are all that happens.
template <class F> bool answered(F&& f) {
    try {
        f();
    } catch (const Error&) {}
    return true;
}

void readAndPack(std::string_view text) {
    Diagnostics diagnostics(LogLevel::silent);
    const Scene scene = readPbrtText(text, "fuzz.pbrt", inputFolder(), diagnostics);
    packScene(scene, diagnostics);
}

/// Reads and packs scenes in which the input is a file of that name.
bool runAsFile(const std::string& name, std::string_view input, std::initializer_list<std::string_view> scenes) {
    writeInput(name, input);
    for (const std::string_view scene : scenes) answered([&] { readAndPack(scene); });
    return true;
}

}  // namespace

bool runPbrt(std::string_view input) {
    if (!staysInFolder(input)) return false;
    return answered([&] {
        Diagnostics diagnostics(LogLevel::silent);
        readPbrtText(input, "fuzz.pbrt", inputFolder(), diagnostics, MissingFiles::magenta);
    });
}

bool runScene(std::string_view input) {
    return staysInFolder(input) && answered([&] { readAndPack(input); });
}

bool runObj(std::string_view input) {
    if (!staysInFolder(input)) return false;
    const std::string_view separator = "#mtl\n";
    const size_t at = std::min(input.find(separator), input.size()), after = std::min(at + separator.size(), input.size());
    if (!staysInFolder(input.substr(after))) return false;
    const std::string path = writeInput("input.obj", input.substr(0, at));
    writeInput("a.mtl", input.substr(after));
    return answered([&] {
        Diagnostics diagnostics(LogLevel::silent);
        packScene(readObj(path, {}, diagnostics), diagnostics);
    });
}

bool runPly(std::string_view input) {
    return runAsFile("input.ply", input, {R"(WorldBegin Shape "plymesh" "string filename" "input.ply")"});
}

bool runLens(std::string_view input) {
    return runAsFile("input.dat", input,
                     {R"(Camera "realistic" "string lensfile" "input.dat" "float aperturediameter" 8 WorldBegin Shape "sphere")"});
}

bool runSpectrum(std::string_view input) {
    return runAsFile("input.spd", input, {R"(WorldBegin LightSource "point" "spectrum I" "input.spd"
        Material "diffuse" "spectrum reflectance" "input.spd" Shape "sphere"
        Material "conductor" "spectrum eta" "input.spd" "spectrum k" "input.spd" Shape "sphere"
        Material "dielectric" "spectrum eta" "input.spd" Shape "sphere")"});
}

bool runMeasured(std::string_view input) {
    return runAsFile("input.bsdf", input, {R"(WorldBegin Material "measured" "string filename" "input.bsdf" Shape "sphere")"});
}

/// A grid of one leaf, as a file without compression: what a fuzzer would have to find is beyond what it tries.
static const std::string& goodGrid() {
    static const std::string bytes = [] {
        const std::string path = inputFolder() + "/good.nvdb";
        writeNanoVdb(path, {{.name = "density", .half = 4, .value = [](int x, int, int) { return 1.f + static_cast<float>(x & 3); }}});
        std::ifstream file(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    }();
    return bytes;
}

bool runNanoVdb(std::string_view input) {
    std::string patched;
    constexpr std::string_view mark = "patch";
    if (input.starts_with(mark)) {
        patched = goodGrid();
        struct Patch { std::uint32_t at; unsigned char bytes[8]; } patch;
        for (input.remove_prefix(mark.size()); input.size() >= sizeof patch; input.remove_prefix(sizeof patch)) {
            std::memcpy(&patch, input.data(), sizeof patch);
            const size_t at = patch.at % (patched.size() - sizeof patch.bytes);
            std::memcpy(&patched[at], patch.bytes, sizeof patch.bytes);
        }
        input = patched;
    }
    return runAsFile("input.nvdb", input, {R"(WorldBegin MakeNamedMedium "m" "string type" "nanovdb" "string filename" "input.nvdb"
        MediumInterface "m" "" Material "interface" Shape "sphere")"});
}

bool runExpression(std::string_view input) {
    answered([&] { readExpression(input, {}, {{"a", 2}, {"b", -0.5}}); });
    if (input.find_first_of("\"\\\n") != input.npos) return true;
    return answered([&] {
        readAndPack("WorldBegin Shape \"implicit\" \"point3 bounds\" [-2 -2 -2 2 2 2] \"float a\" 2 \"float b\" -.5 \"string F\" \"" +
                    std::string(input) + "\"");
    });
}

/// A format without a signature is known by its extension.
bool runImage(std::string_view input) {
    return runAsFile("input.tga", input,
                     {R"(WorldBegin Texture "t" "spectrum" "imagemap" "string filename" "input.tga"
                         Material "diffuse" "texture reflectance" "t" Shape "sphere")",
                      R"(WorldBegin LightSource "infinite" "string filename" "input.tga" Shape "sphere")"});
}

}  // namespace eikonal::fuzz
