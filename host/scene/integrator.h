#pragma once
// How light is carried to the camera: docs/integrators.md says what each computes.

#include "error.h"
#include "color/spectrum.h"

#include <optional>
#include <string>
#include <utility>

namespace eikonal {

enum class IntegratorKind { volpath, path, direct, whitted, ambientOcclusion, simplePath, randomWalk };

/// As scenes and --integrator name them.
inline constexpr std::pair<const char*, IntegratorKind> integratorNames[] = {
    {"volpath", IntegratorKind::volpath}, {"path", IntegratorKind::path}, {"direct", IntegratorKind::direct}, {"whitted", IntegratorKind::whitted},
    {"ambientocclusion", IntegratorKind::ambientOcclusion}, {"simplepath", IntegratorKind::simplePath}, {"simplevolpath", IntegratorKind::volpath},
    {"randomwalk", IntegratorKind::randomWalk}};

/// The most rays that a camera ray may become with IntegratorKind::whitted.
constexpr int mostTreeRays = 64;

/// How the light is chosen that a point is lit by. automatic: by power where lights are few, by the tree where they are many.
enum class LightSampler { automatic, bvh, power, uniform };
/// As scenes and --light-sampler name them.
inline constexpr std::pair<const char*, LightSampler> lightSamplerNames[] = {{"bvh", LightSampler::bvh}, {"power", LightSampler::power}, {"uniform", LightSampler::uniform}};

/// Whether light samples aim at an even sky, by maps of where it is seen. automatic: where a survey finds the scene closed enough.
enum class EnvironmentGuide { automatic, always, never };
/// As --environment-guide names them.
inline constexpr std::pair<const char*, EnvironmentGuide> environmentGuideNames[] = {
    {"auto", EnvironmentGuide::automatic}, {"always", EnvironmentGuide::always}, {"never", EnvironmentGuide::never}};

/// What decides how likely a path of throughput t goes on under Russian roulette: root: sqrt(t), so that half of what is lost is lost in numbers and half in
/// weight (as in Cycles); throughput: t (as in pbrt-v4), so that all paths that are left weigh the same.
enum class RouletteRule { root, throughput };
/// As --roulette names them.
inline constexpr std::pair<const char*, RouletteRule> rouletteRuleNames[] = {{"root", RouletteRule::root}, {"throughput", RouletteRule::throughput}};

/// A path goes on with the probability min(1, scale * t) or min(1, scale * sqrt(t)).
struct Roulette {
    RouletteRule rule = RouletteRule::root;
    double scale = 1;                      ///< in (1e-6, 1e6)
    int depth = 4;                         ///< scattering events before it begins, >= 0; pbrt-v4's is 1
};

struct IntegratorDescription {
    IntegratorKind kind = IntegratorKind::volpath;
    std::string standsFor;                 ///< what the scene asks for, if this takes its place; otherwise empty
    int maxDepth = 5;                      ///< most scattering events on a path
    std::optional<Roulette> roulette;      ///< unset: what pays best in the scene (render/roulette_pilot.h)
    bool regularize = false;
    LightSampler lightSampler = LightSampler::automatic;
    EnvironmentGuide environmentGuide = EnvironmentGuide::automatic;
    bool sampleLights = true;              ///< simplePath: whether lights are sampled; if not, paths have to find them by themselves
    bool sampleBsdf = true;                ///< simplePath: whether directions follow the BSDF; if not, they are uniform
    bool cosine = true;                    ///< ambientOcclusion: whether directions follow the cosine; if not, they are uniform
    double maxDistance = 0;                ///< ambientOcclusion: what is farther away does not occlude, world units; 0: everything does
    ColorSpace colorSpace = ColorSpace::srgb;  ///< ambientOcclusion: whose white the light has
    int rays = 16;                         ///< whitted: the most that a camera ray may become, a power of two, at most mostTreeRays
    int bundle = 4;                        ///< whitted: how many leave a rough surface, 0 or a power of two, at most mostTreeRays
    double threshold = 0.004;              ///< whitted: rays of less weight are not followed
    SourceLocation where;
};

}  // namespace eikonal
