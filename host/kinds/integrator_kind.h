#pragma once
// Every kind of integrator: which parts of a scene it looks at, what it reads, and the numbers that its stages get.

#include <span>
#include <string>

namespace eikonal {

struct IntegratorDescription;
struct Packer;
namespace pbrt { class Arguments; }

/// An `Integrator "name"` of a pbrt scene, also for --integrator. docs/integrators.md describes what each computes.
struct IntegratorKind {
    const char* name;
    const char* parameters = "";          ///< a row of read/pbrt/kinds.h, besides "maxdepth"

    bool countsMedia = false;
    bool countsMaterials = true;          ///< and lights
    bool splitsRays = false;              ///< follows trees of rays
    /// Whether it samples lights, otherwise only paths that hit one find it. Null: it does.
    bool (*samplesLights)(const IntegratorDescription&) = nullptr;
    /// Whether paths scatter as BSDFs do from every surface, so that they find by themselves what shines from everywhere. Null: they do
    /// not.
    bool (*followsBsdfs)(const IntegratorDescription&) = nullptr;

    /// Reads the parameters that the kind has. Null: there are none.
    void (*read)(const pbrt::Arguments&, IntegratorDescription&) = nullptr;
    /// Fills in the settings that the kind uses, and requires its features; `why` says for what. Null: there are none.
    void (*pack)(Packer&, const IntegratorDescription&, const std::string& why) = nullptr;
    int leastDepth = 0, mostDepth = 0x7fffffff;   ///< bounds of the scattering events that are followed, whatever "maxdepth" says
};

extern const IntegratorKind volpath_integrator, path_integrator, direct_integrator, whitted_integrator, ambientocclusion_integrator,
    simplepath_integrator, randomwalk_integrator;
std::span<const IntegratorKind* const> integratorKindList();
/// The name in scene files that is another for "volpath".
constexpr const char* volpathAlias = "simplevolpath";

}  // namespace eikonal
