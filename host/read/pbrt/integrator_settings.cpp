// Fills in the scene's integrator from the parameters of an Integrator directive.

#include "kinds/integrator_kind.h"
#include "read/pbrt/settings.h"

namespace eikonal::pbrt {

void Settings::applyLightSampler(const Arguments& arguments) {
    LightSampler& sampler = reading_.scene.integrator.lightSampler;
    sampler = LightSampler::bvh;   // also for "exhaustive"
    for (const auto& [word, value] : lightSamplerNames)
        if (arguments.text("lightsampler") == word) sampler = value;
}

void Settings::applyIntegrator(const Arguments& arguments) {
    IntegratorDescription& integrator = reading_.scene.integrator;
    const Kind& kind = arguments.kind();
    integrator.where = arguments.where();
    integrator.kind = integratorKindList()[static_cast<size_t>(kind.value)];
    if (kind.standIn) integrator.standsFor = {kind.name, kind.standIn};
    if (kind.rule("maxdepth")) integrator.maxDepth = arguments.integer("maxdepth");
    if (kind.rule("lightsampler") && arguments.has("lightsampler")) applyLightSampler(arguments);
    /* An integrator that is replaced shares "regularize" with the one that replaces it; another name of one has no parameters */
    if (kind.name == integrator.kind->name && integrator.kind->read) integrator.kind->read(arguments, integrator);
    else if (kind.rule("regularize")) integrator.regularize = arguments.flag("regularize");
}

}  // namespace eikonal::pbrt
