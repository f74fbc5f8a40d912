// Procedural cloud: fractal noise, denser towards the bottom (kernels/medium/cloud.clh). It does not emit.

#include "kinds/medium_packing.h"
#include "kinds/medium_reading.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

static bool read(const pbrt::MediumReading& in, Medium& medium) {
    readCoefficients(in.arguments, medium);
    readBox(in.arguments, medium);
    medium.noiseDensity = in.arguments.number("density");
    medium.wispiness = in.arguments.number("wispiness");
    medium.frequency = in.arguments.number("frequency");
    return true;
}

static medium pack(const MediumPacking& in, const Medium& d) {
    medium m = newMedium(in, d);
    packBox(in, d, d.p0, d.p1, m);
    m.low = toVec3(d.p0);
    m.extent = toVec3(d.p1 - d.p0);
    m.noise_density = static_cast<float>(d.noiseDensity);
    m.wispiness = static_cast<float>(d.wispiness);
    m.frequency = static_cast<float>(d.frequency);

    /* Compute majorants of horizontal slabs. Above y = 1/2 the density is at most (1 - y) 4.5 density |noise|, where five octaves of
       noise add up to < 1.01 */
    packMajorants(in.tables, m, {1, 32, 1}, [&](glm::dvec3 low, glm::dvec3 high) {
        const double a = d.p0.y + low.y * m.extent.y, b = d.p0.y + high.y * m.extent.y;
        const double cloud = std::max(std::abs(1 - a), std::abs(1 - b)) * 4.5 * std::abs(d.noiseDensity) * 1.01;
        const double mist = 2 * std::max(0.5 - std::min(a, b), 0.);
        return static_cast<float>(std::min(cloud + mist, 1.));
    });
    return m;
}

const MediumTraits cloud_medium{
    .parameters = {pbrt::phaseParameters, pbrt::coefficientParameters, pbrt::boxParameters,
                   "float density = 1 in [0, inf); float wispiness = 1; float frequency = 5"},
    .read = read, .pack = pack};

}  // namespace eikonal
