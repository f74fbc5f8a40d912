// Fills in the scene's integrator from the parameters of an Integrator directive.

#include "kinds/integrator_kind.h"
#include "read/pbrt/settings.h"

namespace eikonal::pbrt {

void Settings::applyLightSampler(const Arguments& arguments) {
    const std::string name = arguments.text("lightsampler");
    LightSampler& sampler = reading_.scene.integrator.lightSampler;
    std::vector<std::string> words;
    for (const auto& [word, value] : lightSamplerNames) {
        words.emplace_back(word);
        if (name == word) { sampler = value; return; }
    }
    /* pbrt-v4's fourth light sampler; the light tree approximates it, with the same expectation */
    if (name == "exhaustive") { sampler = LightSampler::bvh; return; }
    const std::string near = nearestWord(name, words);
    throw SceneError(arguments.whereOf("lightsampler"),
                     "there is no light sampler \"" + name + "\"; " +
                         (near.empty() ? "there are \"bvh\", \"power\" and \"uniform\"" : "did you mean \"" + near + "\"?"));
}

void Settings::applyIntegrator(const Arguments& arguments) {
    IntegratorDescription& integrator = reading_.scene.integrator;
    const Kind& kind = arguments.kind();
    integrator.where = arguments.where();
    integrator.kind = integratorKindList()[static_cast<size_t>(kind.value)];
    if (kind.standIn) integrator.standsFor = kind.name;
    integrator.maxDepth = arguments.integer("maxdepth");
    if (integrator.maxDepth < 0) throw SceneError(arguments.whereOf("maxdepth"), "\"integer maxdepth\" must not be negative");
    if (kind.rule("lightsampler") && arguments.has("lightsampler")) applyLightSampler(arguments);
    /* An integrator that is replaced shares "regularize" with the one that replaces it; another name of one has no parameters */
    if (kind.name == integrator.kind->name && integrator.kind->read) integrator.kind->read(arguments, integrator);
    else if (kind.rule("regularize")) integrator.regularize = arguments.flag("regularize");
}

}  // namespace eikonal::pbrt
