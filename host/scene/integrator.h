#pragma once
// Light transport settings: docs/integrators.md describes what each integrator computes.

#include "error.h"
#include "color/observer.h"

#include <optional>
#include <string>
#include <utility>

namespace eikonal {

/// With the integrator "whitted", the most rays that one camera ray may split into.
constexpr int mostTreeRays = 64;

/// How the light to sample is chosen. automatic: by power for few lights, by the light tree for many.
enum class LightSampler { automatic, bvh, power, uniform };
/// The names in scene files and for --light-sampler.
inline constexpr std::pair<const char*, LightSampler> lightSamplerNames[] = {
    {"bvh", LightSampler::bvh}, {"power", LightSampler::power}, {"uniform", LightSampler::uniform}};

/// Whether directions are sampled by what pilot paths have learned, too. automatic: where that is measured to pay.
enum class PathGuiding { off, on, automatic };
inline constexpr std::pair<const char*, PathGuiding> pathGuidingNames[] = {
    {"off", PathGuiding::off}, {"on", PathGuiding::on}, {"auto", PathGuiding::automatic}};

/// Whether light samples of an infinite light without an image are guided by its visibility. automatic: if a survey finds the scene closed
/// enough.
enum class EnvironmentGuide { automatic, always, never };
/// The names for --environment-guide.
inline constexpr std::pair<const char*, EnvironmentGuide> environmentGuideNames[] = {
    {"auto", EnvironmentGuide::automatic}, {"always", EnvironmentGuide::always}, {"never", EnvironmentGuide::never}};

/// The survival probability of a path of throughput t under Russian roulette. root: sqrt(t), so throughput loss is split evenly between the
/// number of paths and their weight (as in Cycles). throughput: t (as in pbrt-v4), so all surviving paths have the same weight.
enum class RouletteRule { root, throughput };
/// The names for --roulette.
inline constexpr std::pair<const char*, RouletteRule> rouletteRuleNames[] = {{"root", RouletteRule::root},
                                                                             {"throughput", RouletteRule::throughput}};

/// A path survives with probability min(1, scale * t) or min(1, scale * sqrt(t)).
struct Roulette {
    RouletteRule rule = RouletteRule::root;
    double scale = 1;                      ///< in (1e-6, 1e6)
    int depth = 4;                         ///< scattering events before roulette begins, >= 0; pbrt-v4: 1
};

/// What an integrator computes (kinds/integrator_kind.h).
struct IntegratorKind;
extern const IntegratorKind volpath_integrator;

/// An integrator that is not available and for which another one is used.
struct StandIn {
    std::string name;                      ///< of the integrator that is not available; empty: there is none
    std::string instead;                   ///< a clause that names the other one, and says what it makes of the scene
};

struct IntegratorDescription {
    const IntegratorKind* kind = &volpath_integrator;
    StandIn standsFor;                     ///< if the scene names an integrator that this one replaces
    int maxDepth = 5;                      ///< the most scattering events on a path
    std::optional<Roulette> roulette;      ///< unset: chosen for the scene by pilot paths (render/roulette_pilot.h)
    bool regularize = false;
    LightSampler lightSampler = LightSampler::automatic;
    EnvironmentGuide environmentGuide = EnvironmentGuide::automatic;
    PathGuiding guiding = PathGuiding::off;
    bool sampleLights = true;              ///< simplepath: sample lights; otherwise only paths that hit a light find it
    bool sampleBsdf = true;                ///< simplepath: sample directions by the BSDF, otherwise uniformly
    double mergeRadius = 0;                ///< sppm, vcm: within which vertices merge at first, world units; 0: chosen for the scene
    bool cosine = true;                    ///< ambientocclusion: sample directions by the cosine, otherwise uniformly
    double maxDistance = 0;                ///< ambientocclusion: surfaces farther away do not occlude, world units; 0: no limit
    ColorSpace colorSpace = ColorSpace::srgb;  ///< ambientocclusion: the colour space whose white the light has
    int rays = 16;                         ///< whitted: the most rays per camera ray, a power of two, at most mostTreeRays
    int bundle = 4;                        ///< whitted: rays that leave a rough surface, 0 or a power of two, at most mostTreeRays
    double threshold = 0.004;              ///< whitted: rays of smaller weight are not traced
    SourceLocation where;
};

}  // namespace eikonal
