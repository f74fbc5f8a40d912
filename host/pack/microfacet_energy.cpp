#include "pack/microfacet_energy.h"

#include "eikonal/bsdfs.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

using glm::dvec3;

/// GGX microfacets, as in kernels/bsdf/microfacet.clh.
struct Facets {
    double x, y;
    double lambda(const dvec3& w) const {
        return 0.5 * (std::sqrt(1 + (x * x * w.x * w.x + y * y * w.y * w.y) / std::max(w.z * w.z, 1e-20)) - 1);
    }
    dvec3 sampleVisible(const dvec3& w, double u, double v) const {
        const dvec3 o = glm::normalize(dvec3(x * w.x, y * w.y, w.z));
        const double z = 1 - v - v * o.z, r = std::sqrt(std::max(0., 1 - z * z)), turn = 2 * M_PI * u;
        const dvec3 h(r * std::cos(turn) + o.x, r * std::sin(turn) + o.y, z + o.z);
        return glm::normalize(dvec3(x * h.x, y * h.y, std::max(h.z, 1e-7)));
    }
};

/// Unpolarised reflectance. cosine > 0; n: far index over near index.
double fresnel(double cosine, double n) {
    const double c = std::min(cosine, 1.), s2 = 1 - c * c, w2 = n * n - s2;
    if (w2 <= 0) return 1;
    const double w = std::sqrt(w2), perpendicular = (c - w) / (c + w), ratio = (c * w - s2) / (c * w + s2);
    return std::min(0.5 * perpendicular * perpendicular * (1 + ratio * ratio), 1.);
}

/// What single scattering keeps of the light from a direction, and what of that is transmitted.
struct Kept { double all = 0, transmitted = 0; };

/// n: far index over near index; 0: all light is reflected. Averages over a lattice of visible normals, denser where they are steep.
Kept keptFrom(const Facets& facets, const dvec3& wo, double n) {
    constexpr int points = 2584, generator = 1597;   // Fibonacci numbers
    const double lambda = facets.lambda(wo);
    const auto shadowing = [&](const dvec3& wi) { return (1 + lambda) / (1 + lambda + facets.lambda(wi)); };
    Kept kept;
    for (int i = 0; i < points; ++i) {
        const double left = 1 - (i + 0.5) / points, weight = 2 * left / points;
        const dvec3 m = facets.sampleVisible(wo, static_cast<double>(i * generator % points) / points, 1 - left * left);
        const double cosine = std::max(glm::dot(wo, m), 1e-12), R = n > 0 ? fresnel(cosine, n) : 1;
        const dvec3 mirrored = 2 * cosine * m - wo;
        if (mirrored.z > 0) kept.all += weight * R * shadowing(mirrored);
        if (R >= 1) continue;
        const double cosineThere = std::sqrt(std::max(0., 1 - (1 - cosine * cosine) / (n * n)));
        const dvec3 refracted = (cosine / n - cosineThere) * m - wo / n;
        if (refracted.z < 0) kept.transmitted += weight * (1 - R) * shadowing(refracted);
    }
    kept.all += kept.transmitted;
    return kept;
}

constexpr int cosines = ENERGY_COSINES;
/// The azimuth and the cosine of a node, or of a place between nodes.
double azimuthAt(double node, uint nodes) { return nodes > 1 ? std::atan2(node, nodes - 1 - node) : 0; }
double cosineAt(double node, double width) {
    const double x = node * node / ((cosines - 1.) * (cosines - 1.)), a = width + 0.3;
    return std::clamp(x * a / (1 + a - x), 1e-6, 1.);
}
double widthTowards(const Facets& f, double phi) { return std::hypot(f.x * std::cos(phi), f.y * std::sin(phi)); }

/// Words of the record of a surface's side.
void writeRecord(const Facets& facets, double n, uint azimuths, float* record) {
    std::vector<Kept> kept(azimuths * cosines);
    for (uint a = 0; a < azimuths; ++a)
        for (uint c = 0; c < cosines; ++c) {
            const double phi = azimuthAt(a, azimuths), z = cosineAt(c, widthTowards(facets, phi)), r = std::sqrt(1 - z * z);
            kept[a * cosines + c] = keptFrom(facets, {r * std::cos(phi), r * std::sin(phi), z}, n);
            record[energy_directions + a * cosines + c] = static_cast<float>(1 - kept[a * cosines + c].all);
        }
    /* Average what kernels interpolate: the middle of eight steps between any two nodes along an axis */
    constexpr int steps = 8;
    Kept sum;
    double area = 0;
    const uint acrossSteps = azimuths > 1 ? (azimuths - 1) * steps : 1;
    for (uint i = 0; i < acrossSteps; ++i) {
        const double a = azimuths > 1 ? (i + 0.5) / steps : 0, phi = azimuthAt(a, azimuths), width = widthTowards(facets, phi);
        const double wedge = azimuths > 1 ? azimuthAt((i + 1.) / steps, azimuths) - azimuthAt(double(i) / steps, azimuths) : 1;
        const uint a0 = static_cast<uint>(a), a1 = std::min(a0 + 1, azimuths - 1);
        for (int j = 0; j < (cosines - 1) * steps; ++j) {
            const double c = (j + 0.5) / steps, low = cosineAt(double(j) / steps, width), high = cosineAt((j + 1.) / steps, width);
            const uint c0 = static_cast<uint>(c);
            const auto at = [&](uint across, uint along) { return kept[across * cosines + along]; };
            const auto between = [&](double Kept::*part) {
                const double f = c - c0, g = a - a0;
                return (1 - g) * ((1 - f) * at(a0, c0).*part + f * at(a0, c0 + 1).*part) +
                       g * ((1 - f) * at(a1, c0).*part + f * at(a1, c0 + 1).*part);
            };
            const double piece = wedge * (high * high - low * low);
            area += piece;
            sum.all += piece * between(&Kept::all);
            sum.transmitted += piece * between(&Kept::transmitted);
        }
    }
    record[energy_average] = static_cast<float>(1 - sum.all / area);
    record[energy_transmitted] = static_cast<float>(sum.transmitted / std::max(sum.all, 1e-12));
}

/// The width of a node.
double widthOf(const std::optional<double>& constant, uint node, uint nodes) {
    if (constant) return std::max(*constant, double(MIN_ALPHA));
    const double x = double(MOST_ENERGY_WIDTH) * node / (nodes - 1);
    return std::max(x / (1 - x), double(MIN_ALPHA));
}

}  // namespace

uint MicrofacetEnergyPacker::table(const MicrofacetSurface& s) {
    const auto [found, isNew] = tablesOf_.try_emplace(s.key(), static_cast<uint>(tables_.energy_tables.size()));
    if (!isNew) return found->second;

    /* Few nodes where many axes vary: each record takes a millisecond or more */
    const bool varyBoth = !s.isotropic && !s.alphaX && !s.alphaY;
    const uint widths = varyBoth ? 10 : 32;
    energy_table t{};
    t.first = static_cast<uint>(tables_.energy_values.size());
    t.azimuths = s.isotropic ? 1 : varyBoth ? 7 : 13;
    t.widths_x = s.alphaX ? 1 : widths;
    t.widths_y = s.isotropic || s.alphaY ? 1 : widths;
    t.sides = s.lowestIndex > 0 ? 2 : 1;
    t.indices = s.highestIndex > s.lowestIndex ? 5 : 1;
    const double indexStep = t.indices > 1 ? (s.highestIndex - s.lowestIndex) / (t.indices - 1) : 0;
    t.first_index = static_cast<float>(s.lowestIndex);
    t.indices_per_unit = indexStep > 0 ? static_cast<float>(1 / indexStep) : 0;

    const size_t record = energy_directions + t.azimuths * ENERGY_COSINES, records = size_t(t.widths_x) * t.widths_y * t.sides * t.indices;
    tables_.energy_values.resize(t.first + record * records);
    tbb::parallel_for(size_t(0), records, [&](size_t i) {
        const uint x = static_cast<uint>(i % t.widths_x), y = static_cast<uint>(i / t.widths_x % t.widths_y);
        const size_t sides = i / t.widths_x / t.widths_y;
        const double index = s.lowestIndex + indexStep * static_cast<double>(sides / t.sides);
        const double alphaX = widthOf(s.alphaX, x, t.widths_x), alphaY = s.isotropic ? alphaX : widthOf(s.alphaY, y, t.widths_y);
        writeRecord({alphaX, alphaY}, index > 0 && sides % t.sides == 1 ? 1 / index : index, t.azimuths,
                    tables_.energy_values.data() + t.first + i * record);
    });
    tables_.energy_tables.push_back(t);
    constants_.energyTables = static_cast<int>(tables_.energy_tables.size());
    return found->second;
}

}  // namespace eikonal
