#include "app/trade/followed_light.h"

#include "app/trade/setting.h"
#include "app/trade/setting_renderer.h"
#include "kinds/integrator_kind.h"
#include "pack/missed_light.h"
#include "render/session.h"

namespace eikonal {

const IntegratorKind* followerOf(const Session& session, const std::string& scene, const std::vector<std::string>& options) {
    const bool isHidden = session.packed().features.has(Feature::LIGHT_PATHS) || !lightForLightPaths(session.packed()).empty();
    if (!isHidden || !partOfTransport(session.scene()).empty()) return nullptr;
    Diagnostics silent(LogLevel::silent);
    const Options following = renderOptions(scene, overridden(options, {integratorOption(bdpt_integrator)}));
    Session both(following, silent);
    both.load(false);
    both.pack({});
    if (!both.packed().features.has(Feature::LIGHT_PATHS)) return nullptr;
    return missesLightForGood(both.packed()) ? &vcm_integrator : &bdpt_integrator;
}

}  // namespace eikonal
