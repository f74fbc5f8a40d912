#pragma once
// The command line: every option is declared once, in options.cpp, with its help and its check.

#include "diagnostics.h"
#include "image/tone_map.h"
#include "scene/scene.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

enum class Command { print, render, info, bench, cache, listDevices, compare, compileKernels };

/// What replaces what the scene file says. Unset: the file's.
struct SceneOptions {
    std::string path;
    std::optional<int> spp;                           ///< samples a pixel, >= 1
    std::optional<int> seed;
    std::optional<SamplerKind> sampler;
    std::optional<ColorMode> colorMode;
    std::optional<IntegratorKind> integrator;
    std::optional<SubsurfaceMethod> subsurface;       ///< of all materials "subsurface"
    std::optional<int> maxDepth;                      ///< bounces, >= 0
    std::optional<RouletteRule> roulette;
    std::optional<double> rouletteScale;              ///< > 0
    std::optional<int> rouletteDepth;                 ///< bounces before Russian roulette, >= 0
    std::optional<LightSampler> lightSampler;
    std::optional<EnvironmentGuide> environmentGuide;
    std::optional<std::array<int, 2>> resolution;     ///< width and height in pixels
    std::optional<std::array<double, 4>> cropWindow;  ///< x0 x1 y0 y1, fractions of the image
    std::optional<PixelBounds> pixelBounds;
    std::optional<glm::dvec3> camera, lookAt, up;     ///< OBJ only, world space
    std::optional<double> fov;                        ///< OBJ only, degrees along the shorter side, in (0, 180)
    bool strict = false;
};

/// Where and how kernels run.
struct DeviceOptions {
    std::string device;                               ///< a number of --list-devices or a part of a name; empty: the best
    int threads = 0;                                  ///< of the host and of PoCL; 0: one a core
    bool list = false;                                ///< print the devices instead of what the command does
    bool cache = true;
    std::string dumpFolder;                           ///< not empty: each program's text goes there
    std::optional<unsigned> wavePaths, localSize, itemsPerWorkItem;
    bool contraction = true;
    std::string buildOptions;                         ///< for OpenCL's compiler, besides its own
};

/// Channels of an EXR besides colour.
struct Aovs {
    bool albedo = false, normal = false, geometricNormal = false, position = false, uv = false, depthSlope = false, motion = false, depth = false, object = false, material = false;
    bool variance = false, sampleCount = false;
    bool any() const;
    /// Whether the device has to keep what paths see.
    bool ofSurfaces() const;
};

/// What --aov calls each of them.
struct AovName { const char* name; bool Aovs::*asked; bool isOfSurfaces = true; };
inline constexpr AovName aovNames[] = {{"albedo", &Aovs::albedo}, {"normal", &Aovs::normal}, {"geometricNormal", &Aovs::geometricNormal}, {"position", &Aovs::position},
                                       {"uv", &Aovs::uv}, {"depthSlope", &Aovs::depthSlope}, {"motion", &Aovs::motion},
                                       {"depth", &Aovs::depth}, {"object", &Aovs::object}, {"material", &Aovs::material},
                                       {"variance", &Aovs::variance, false}, {"sampleCount", &Aovs::sampleCount, false}};
inline bool Aovs::any() const { return std::ranges::any_of(aovNames, [this](const AovName& n) { return this->*n.asked; }); }
inline bool Aovs::ofSurfaces() const { return std::ranges::any_of(aovNames, [this](const AovName& n) { return n.isOfSurfaces && this->*n.asked; }); }

struct OutputOptions {
    std::vector<std::string> files;                   ///< empty: the scene's name, .exr
    Aovs aovs;
    ToneMapping toneMapping;
    std::optional<double> timeLimit;                  ///< seconds of rendering
    std::optional<double> targetError;                ///< root of the mean relative squared error to come down to, > 0
    bool stats = false;
};

/// What a worker of commands/kernel_workers.h compiles: every `parts`-th stage from the `part`-th on, of scenes with these features.
/// `parent`: the process that it ends with; 0: none.
struct CompileRequest { std::string features, constants; unsigned part = 0, parts = 1; int parent = 0; };

struct Options {
    Command command = Command::print;
    std::string text;                                 ///< what Command::print prints
    std::string commandLine;                          ///< as the user gave it
    LogLevel log = LogLevel::warning;
    bool quiet = false;
    SceneOptions scene;
    DeviceOptions device;
    OutputOptions output;
    bool json = false;                                ///< info: print JSON
    std::string jsonFile;                             ///< bench: not empty, write JSON there
    bool loop = false;                                ///< bench
    bool efficiency = false;                          ///< bench: each repeat has a seed of its own
    int repeats = 5;                                  ///< bench
    bool clearCache = false, warmCache = false;       ///< cache
    std::vector<std::string> scenes;                  ///< cache --warm
    std::string image;                                ///< compare
    std::string reference;                            ///< compare, bench: a converged image; bench: empty: none
    bool scatter = false;                             ///< compare: what an image says of its variance does not count
    CompileRequest compile;
};

/// What the command line asks for. `arguments` begins with the program's name. Throws a UsageError that says what would have worked.
Options parseOptions(const std::vector<std::string>& arguments);

/// Every option of every command, long spelling, for the test that holds docs/command-line.md to it.
std::vector<std::string> allOptionNames();

}  // namespace eikonal
