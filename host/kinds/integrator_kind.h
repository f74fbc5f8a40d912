#pragma once
// Integrators: which parts of a scene each one uses, what it reads from the scene file, and its settings for the stages.

#include <optional>
#include <span>
#include <string>

namespace eikonal {

struct IntegratorDescription;
struct IntegratorPacking;
namespace pbrt { class Arguments; }

/// An `Integrator "name"` of a pbrt scene, also for --integrator. docs/integrators.md describes what each computes.
struct IntegratorKind {
    const char* name;
    const char* parameters = "";          ///< a row of read/pbrt/kinds.h, without "maxdepth"

    bool countsMedia = false;
    /// The queue of all surfaces (enum next_queue of stages.h). Nothing: the queues of their BSDFs; then lights count, too.
    std::optional<unsigned> surfaceQueue{};
    bool countsMaterials() const { return !surfaceQueue; }   ///< and lights
    bool mayTraceLightPaths = false;      ///< light paths are traced where paths from the camera miss light (pack/light_paths.h)
    bool splitsRays = false;              ///< several rays may leave a hit
    /// Whether it samples lights; otherwise paths only find the lights that they hit. Null: always.
    bool (*samplesLights)(const IntegratorDescription&) = nullptr;
    /// Whether every bounce samples the BSDF, so that uniform environments need no light samples. Null: no.
    bool (*followsBsdfs)(const IntegratorDescription&) = nullptr;

    /// Reads the kind's parameters. Null: there are none.
    void (*read)(const pbrt::Arguments&, IntegratorDescription&) = nullptr;
    /// Fills in the kind's settings and requires its features, with `why` as the reason. Null: it has neither.
    void (*pack)(const IntegratorPacking&, const IntegratorDescription&, const std::string& why) = nullptr;
    int leastDepth = 0, mostDepth = 0x7fffffff;   ///< "maxdepth" is clamped to this range
};

extern const IntegratorKind volpath_integrator, path_integrator, direct_integrator, whitted_integrator, ambientocclusion_integrator,
    simplepath_integrator, randomwalk_integrator, bdpt_integrator, sppm_integrator, vcm_integrator, auto_integrator;
std::span<const IntegratorKind* const> integratorKindList();
/// IntegratorKind::samplesLights and followsBsdfs of an integrator.
bool samplesLights(const IntegratorDescription&);
bool followsBsdfs(const IntegratorDescription&);
/// Another name for "volpath" in scene files.
constexpr const char* volpathAlias = "simplevolpath";

}  // namespace eikonal
