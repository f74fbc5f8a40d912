#pragma once
// The options of a session: a scene with overrides, a device, and channels of the image.

#include "device/math_flags.h"
#include "diagnostics.h"
#include "read/formats/loose_files.h"
#include "scene/scene.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// Options that override the scene file. Unset: the file's value counts.
struct SceneOptions {
    std::string path;
    std::optional<int> spp;                           ///< samples per pixel, >= 1
    std::optional<int> seed;
    std::optional<SamplerKind> sampler;
    std::optional<ColorMode> colorMode;
    const IntegratorKind* integrator = nullptr;         ///< null: the scene's
    std::optional<SubsurfaceMethod> subsurface;       ///< for all materials "subsurface"
    std::optional<int> maxDepth;                      ///< bounces, >= 0
    std::optional<RouletteRule> roulette;
    std::optional<double> rouletteScale;              ///< > 0
    std::optional<int> rouletteDepth;                 ///< bounces before Russian roulette, >= 0
    std::optional<LightSampler> lightSampler;
    std::optional<EnvironmentGuide> environmentGuide;
    std::optional<PathGuiding> guiding;
    std::optional<bool> regularize;
    std::optional<double> maxComponentValue;          ///< of the film, >= 0; 0: no clamping
    std::optional<bool> reweightsFireflies;           ///< of the film
    std::optional<double> treeThreshold;              ///< of the integrator whitted, in [0, 1)
    std::optional<int> treeBundle;                    ///< of the integrator whitted: 0 or a power of two, at most mostTreeRays
    std::optional<std::array<int, 2>> resolution;     ///< width and height in pixels
    std::optional<std::array<double, 4>> cropWindow;  ///< x0 x1 y0 y1, fractions of the image
    std::optional<PixelBounds> pixelBounds;
    std::optional<glm::dvec3> camera, lookAt, up;     ///< OBJ only, world space
    std::optional<double> fov;                        ///< OBJ only, degrees along the shorter side, in (0, 180)
    std::optional<int> frame;                         ///< of an animation, >= 0; unset: the scene as it is
    std::optional<double> fps;                        ///< pbrt only: frames per unit of the scene's time, > 0
    std::optional<double> shutter;                    ///< with fps: the share of a frame that the shutter is open, > 0; unset: the scene's
    std::optional<int> turntable;                     ///< OBJ only: frames of a full turn of the camera about the model, > 0
    MissingFiles missingFiles = MissingFiles::error;
    bool strict = false;
    bool isSubsurfaceOfPreset = false;                ///< chosen by --quality; it may have no effect in a scene
};

/// Where and how kernels run.
struct DeviceOptions {
    std::string device;                               ///< an index from --list-devices or part of a name; empty: the default device
    int threads = 0;                                  ///< of the host and of PoCL; 0: one per core
    bool list = false;                                ///< print the devices instead of running the command
    bool cache = true;
    std::string dumpFolder;                           ///< if not empty, the source of each program is written there
    std::optional<unsigned> wavePaths, localSize, itemsPerWorkItem;
    bool contraction = true;
    std::string buildOptions;                         ///< for the OpenCL compiler, in addition to the default ones
    std::vector<StageFlags> mathFlags;                ///< instead of shippedMathFlags
    /// buildOptions and all mathFlags.
    std::string compilerFlags() const {
        std::string all = buildOptions;
        for (const StageFlags& s : mathFlags) all += " " + s.flags;
        return all;
    }
};

/// What a channel is made of: the first surface of each path, its light by passes or by light groups, or the film's statistics, which there
/// are anyway; or weights of what first surfaces are called.
enum class AovSource { surfaces, passes, lightGroups, statistics, names };

/// Additional channels of an EXR.
struct Aovs {
    bool albedo = false, normal = false, geometricNormal = false, position = false, uv = false, depthSlope = false, motion = false,
         depth = false, object = false, material = false;
    bool emission = false, direct = false, indirect = false, volume = false;
    bool lightGroups = false;
    bool cryptoObject = false, cryptoMaterial = false;
    bool variance = false, sampleCount = false;
    bool any() const;
    /// Whether any channel is of this source.
    bool has(AovSource source) const;
};

/// The names of the channels for --aov.
struct AovName { const char* name; bool Aovs::*asked; AovSource source = AovSource::surfaces; };
inline constexpr AovName aovNames[] = {{"albedo", &Aovs::albedo},
                                       {"normal", &Aovs::normal},
                                       {"geometricNormal", &Aovs::geometricNormal},
                                       {"position", &Aovs::position},
                                       {"uv", &Aovs::uv},
                                       {"depthSlope", &Aovs::depthSlope},
                                       {"motion", &Aovs::motion},
                                       {"depth", &Aovs::depth},
                                       {"object", &Aovs::object},
                                       {"material", &Aovs::material},
                                       {"emission", &Aovs::emission, AovSource::passes},
                                       {"direct", &Aovs::direct, AovSource::passes},
                                       {"indirect", &Aovs::indirect, AovSource::passes},
                                       {"volume", &Aovs::volume, AovSource::passes},
                                       {"lightgroups", &Aovs::lightGroups, AovSource::lightGroups},
                                       {"cryptoObject", &Aovs::cryptoObject, AovSource::names},
                                       {"cryptoMaterial", &Aovs::cryptoMaterial, AovSource::names},
                                       {"variance", &Aovs::variance, AovSource::statistics},
                                       {"sampleCount", &Aovs::sampleCount, AovSource::statistics}};
inline bool Aovs::any() const { return std::ranges::any_of(aovNames, [this](const AovName& n) { return this->*n.asked; }); }
inline bool Aovs::has(AovSource source) const {
    return std::ranges::any_of(aovNames, [&](const AovName& n) { return n.source == source && this->*n.asked; });
}

/// The work of a process of render/kernel_workers.h: compiles every `parts`-th stage, starting with the `part`-th, for scenes with these
/// features and constants. `parent`: the process whose end also ends the worker; 0: none.
struct CompileRequest { std::string features, constants; unsigned part = 0, parts = 1; int parent = 0; };

/// What to render, and where.
struct SessionOptions {
    SceneOptions scene;
    DeviceOptions device;
    LogLevel log = LogLevel::warning;
};

}  // namespace eikonal
