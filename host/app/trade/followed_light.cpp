#include "app/trade/followed_light.h"

#include "app/trade/setting.h"
#include "app/trade/setting_renderer.h"
#include "pack/missed_light.h"
#include "render/session.h"

namespace eikonal {

std::optional<std::string> followerOf(const Session& session, const std::string& scene, const std::vector<std::string>& options) {
    const bool isHidden = session.packed().features.has(Feature::LIGHT_PATHS) || !missedLight(session.packed()).empty();
    if (!isHidden || !partOfTransport(session.scene()).empty()) return std::nullopt;
    const std::string unbiased = "--integrator=bdpt";
    Diagnostics silent(LogLevel::silent);
    const Options following = renderOptions(scene, overridden(options, {unbiased}));
    Session both(following, silent);
    both.load(false);
    both.pack({});
    if (!both.packed().features.has(Feature::LIGHT_PATHS)) return std::nullopt;
    return missesLightForGood(both.packed()) ? "--integrator=vcm" : unbiased;
}

}  // namespace eikonal
