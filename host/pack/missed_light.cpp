#include "pack/missed_light.h"

#include "kinds/light_kind.h"
#include "pack/smooth_bsdfs.h"
#include "pack/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eikonal {

static constexpr double rareShare = 1e-3;

/// What first asked for a feature; empty if nothing did.
static std::string firstUse(const PackedScene& packed, Feature feature) {
    const auto found = packed.reasons.find(feature);
    return found == packed.reasons.end() ? "" : found->second;
}

/// Which smooth surfaces count. Light paths end at subsurface bodies.
enum class Smooth { any, bodies, others };

/// Whether a material with that BSDF is, or is not, that of a subsurface body.
static bool hasMaterial(const PackedScene& packed, next_queue queue, bool ofBody) {
    return std::ranges::any_of(packed.tables.materials, [&](const material& m) {
        return m.next_queue == queue && (m.interior != NONE || m.profile != NONE) == ofBody;
    });
}

/// The first surface that only reflects and transmits in single directions, with its place in the scene; empty if there is none.
static std::string firstSmooth(const PackedScene& packed, Smooth which) {
    if (packed.features.has(Feature::FORCE_DIFFUSE)) return {};
    for (const auto& [feature, queue, what] : smoothBsdfs) {
        const std::string where = firstUse(packed, feature);
        if (where.empty()) continue;
        if (which == Smooth::bodies && hasMaterial(packed, queue, true))
            return fmt::format("a subsurface body ({})", firstUse(packed, Feature::SUBSURFACE));
        const bool counts = which == Smooth::any || (which == Smooth::others && hasMaterial(packed, queue, false));
        if (counts) return fmt::format("{} ({})", what, where);
    }
    return {};
}

/// The area of the smallest lamp, all elements of a shape together, over the cross-section of the scene; infinite without lamps.
static double smallestLamp(const PackedScene& packed) {
    const auto& lights = packed.tables.lights;
    double smallest = INFINITY;
    for (const shape& s : packed.tables.shapes) {
        if (s.first_light == NONE || s.first_light >= lights.size()) continue;
        double area = 0;
        for (size_t i = s.first_light; i < lights.size() && lights[i].element != NONE; ++i) {
            if (&packed.tables.shapes[packed.tables.element_shapes[lights[i].element]] != &s) break;
            if (lights[i].inverse_area > 0) area += 1 / double{lights[i].inverse_area};
        }
        if (area > 0) smallest = std::min(smallest, area / M_PI);
    }
    return smallest;
}

/// A light that no path can hit. Null: there is none.
static const light* firstWithoutArea(const PackedScene& packed) {
    const auto hasNone = [](const light& l) { return kindOf(l).place == LightPlace::POINT || kindOf(l).place == LightPlace::DISTANT; };
    const auto found = std::ranges::find_if(packed.tables.lights, hasNone);
    return found == packed.tables.lights.end() ? nullptr : &*found;
}

bool missesLightForGood(const PackedScene& packed) {
    return !packed.features.has(Feature::MERGING) && !firstSmooth(packed, Smooth::others).empty() && firstWithoutArea(packed);
}

static std::vector<std::string> missedLight(const PackedScene& packed, Smooth which) {
    const std::string smooth = firstSmooth(packed, which);
    if (smooth.empty()) return {};
    /* Light paths arrive at the camera from surfaces that it sees directly */
    const bool fromBothEnds = packed.features.has(Feature::LIGHT_PATHS);
    const std::string onto = which == Smooth::bodies ? "onto surfaces by way of smooth ones that light paths do not pass"
                             : fromBothEnds ? "onto surfaces by way of smooth ones, where they are seen by way of smooth ones, too"
                                            : "onto surfaces by way of smooth ones";
    std::vector<std::string> missed;
    if (const light* l = firstWithoutArea(packed)) {
        const std::string where = firstUse(packed, kindOf(*l).feature);
        missed.push_back(fmt::format("what a {} light{} sends {}, first {}, is missing: no path from the camera can hit such a light",
                                     kindOf(*l).name, where.empty() ? "" : " (" + where + ")", onto, smooth));
    }
    if (const double share = smallestLamp(packed); share < rareShare)
        missed.push_back(fmt::format("what a lamp of {:.1e} of the scene's cross-section sends {}, first {}, is noisy: about one path in "
                                     "{:.0f} hits the lamp",
                                     share, onto, smooth, 1 / share));
    return missed;
}

std::vector<std::string> missedLight(const PackedScene& packed) {
    /* Where paths from both ends merge, they meet on the surface in between */
    return missedLight(packed, packed.features.has(Feature::MERGING) ? Smooth::bodies : Smooth::any);
}
std::vector<std::string> lightForLightPaths(const PackedScene& packed) {
    return packed.features.has(Feature::MERGING) ? std::vector<std::string>() : missedLight(packed, Smooth::others);
}

}  // namespace eikonal
