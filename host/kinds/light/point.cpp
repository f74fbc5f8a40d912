// Point light: the same intensity in all directions (kernels/light/point.clh).

#include "kinds/light_packing.h"
#include "kinds/light_reading.h"

#include <cmath>

namespace eikonal {

static bool read(const pbrt::LightReading& in, Light& light) {
    light.spectrum = in.arguments.spectrum("I", whiteOf(in.arguments));
    light.from = in.arguments.vector("from");
    if (const auto power = strengthOf(in.reading, in.arguments, "power")) light.scale *= *power / (4 * M_PI);
    return true;
}

static PackedLight pack(const LightPacking& in, const Light& d) {
    const double factor = d.scale * intensityScale(in.context);
    light l = newLight(kind_point_light, in.colors.emission(d.spectrum, factor));
    l.p = toVec3(transformPoint(in.context.space.sceneFromWorld() * d.worldFromLight, d.from));
    return {l, 4 * M_PI * luminanceOf(d.spectrum, factor)};
}

const LightTraits point_light{.directive = "point", .parameters = "spectrum I; float power = -1; point3 from", .read = read,
                                   .hasDirections = false, .pack = pack, .bound = boundPoint};

}  // namespace eikonal
