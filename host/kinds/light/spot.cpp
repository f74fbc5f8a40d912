// Spotlight: a point light with a cone that falls off smoothly at its edge (kernels/light/spot.clh).

#include "kinds/light_packing.h"
#include "kinds/light_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eikonal {

static bool read(const pbrt::LightReading& in, Light& light) {
    const pbrt::Arguments& arguments = in.arguments;
    light.spectrum = arguments.spectrum("I", whiteOf(arguments));
    readDirection(arguments, light);
    light.coneAngle = arguments.number("coneangle");
    light.coneDeltaAngle = arguments.number("conedeltaangle");
    if (light.coneDeltaAngle > 2 * light.coneAngle) {
        in.reading.diagnostics.warnOnce(
            "conedeltaangle", arguments.whereOf("conedeltaangle"),
            fmt::format("{}: \"float conedeltaangle\" is {:g}, more than twice coneangle; it counts as coneangle, {:g}",
                        arguments.kind().title(), light.coneDeltaAngle, light.coneAngle));
        light.coneDeltaAngle = light.coneAngle;
    }
    if (const auto power = strengthOf(in.reading, arguments, "power")) {
        const double end = std::cos(glm::radians(light.coneAngle)), start = std::cos(glm::radians(light.coneAngle - light.coneDeltaAngle));
        light.scale *= *power / (2 * M_PI * ((1 - start) + (start - end) / 2));
    }
    return true;
}

static PackedLight pack(const LightPacking& in, const Light& d) {
    const double outer = std::cos(glm::radians(d.coneAngle)), inner = std::cos(glm::radians(d.coneAngle - d.coneDeltaAngle));
    const double solidAngle = 2 * M_PI * ((1 - inner) + (inner - outer) / 2);
    const double factor = d.scale * intensityScale(in.context);
    light l = newLight(kind_spot_light, in.colors.emission(d.spectrum, factor));
    l.p = toVec3(transformPoint(in.context.space.sceneFromWorld() * d.worldFromLight, d.from));
    l.n = toVec3(glm::normalize(transformVector(d.worldFromLight, d.to - d.from)));
    l.cos_inner = static_cast<float>(inner);
    l.cos_outer = static_cast<float>(outer);
    return {l, solidAngle * luminanceOf(d.spectrum, factor)};
}

static void bound(const light& l, double power, LightBounds& bounds) {
    const double inner = std::acos(std::clamp<double>(l.cos_inner, -1, 1)), outer = std::acos(std::clamp<double>(l.cos_outer, -1, 1));
    bounds.emission = std::clamp(outer - inner, leastEmission, mostFallOff);
    bounds.normals = std::max(inner, outer - bounds.emission);
    bounds.intensity = power / (2 * std::numbers::pi * (1 - (l.cos_inner + l.cos_outer) / 2));
}

const LightTraits spot_light{
    .directive = "spot",
    .parameters =
        "spectrum I; float power = -1; point3 from; point3 to; float coneangle = 30 in (0, 180]; float conedeltaangle = 5 in [0, 180]",
    .read = read,
    .pack = pack,
    .bound = bound};

}  // namespace eikonal
