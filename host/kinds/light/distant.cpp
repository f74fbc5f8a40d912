// Distant light: parallel rays (kernels/light/distant.clh).

#include "kinds/light_packing.h"
#include "kinds/light_reading.h"

#include <cmath>

namespace eikonal {

static bool read(const pbrt::LightReading& in, Light& light) {
    light.spectrum = in.arguments.spectrum("L", whiteOf(in.arguments));
    readDirection(in.arguments, light);
    if (const auto illuminance = strengthOf(in.reading, in.arguments, "illuminance")) light.scale *= *illuminance;
    return true;
}

static PackedLight pack(const LightPacking& in, const Light& d) {
    light l = newLight(kind_distant_light, in.colors.emission(d.spectrum, d.scale));
    l.n = toVec3(glm::normalize(transformVector(d.worldFromLight, d.from - d.to)));
    l.extent = static_cast<float>(in.context.whole.empty() ? 0 : 2 * in.context.whole.radius() * in.context.space.scale);
    return {l, M_PI * sceneRadius(in.context) * sceneRadius(in.context) * luminanceOf(d.spectrum, d.scale)};
}

const LightTraits distant_light{
    .directive = "distant", .parameters = "spectrum L; float illuminance = -1; point3 from; point3 to", .read = read, .pack = pack};

}  // namespace eikonal
