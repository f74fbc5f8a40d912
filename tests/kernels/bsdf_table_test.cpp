// Energy, density and reciprocity of every BSDF over roughness, index and angle: rows for tests/accuracy/bsdf_table.py.

#include "bsdf_density.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

namespace eikonal {
namespace {

bool isWidth(const BsdfParameter& p) {
    return p.name.find("alpha") != std::string::npos || p.name == "beta_m" || p.name == "beta_n";
}
bool isIndex(const BsdfParameter& p) { return p.name == "eta" && p.type == "float"; }

/// Matter that absorbs nothing: white, metal of reflectance 0.9999, no medium, no pigment.
float whiteValue(const BsdfParameter& p, float alpha, float eta) {
    if (isWidth(p)) return alpha;
    if (isIndex(p)) return eta;
    if (p.name == "k" || p.name == "metal_k") return 200;
    if (p.name == "max_depth") return 100;
    if (p.name == "transmittance" || p.name == "reflectance" || p.name == "metallic") return p.name == "reflectance" ? 1 : 0;
    if (p.name == "thickness" || p.name == "sigma_a" || p.name == "h" || p.name == "scale_tilt" || p.name == "coat" || p.name == "sheen" ||
        p.name == "g" || p.name == "file" || (p.name == "albedo" && p.type == "spectrum"))
        return 0;
    return 1;
}

/// p of the chi-square test, or nothing where the quadrature does not resolve the density: where a finer one gives counts that differ by
/// more than a twentieth of what the test tells from noise.
std::string probability(const BsdfProbe& probe, const std::vector<uint>& b, vec3 wo, const std::vector<BsdfResult>& sampled,
                        Random& random) {
    BsdfInputs in;
    for (vec3 direction : sphereQuadrature(true).directions) in.add(b, wo, direction, random);
    const double n = static_cast<double>(sampled.size());
    const std::vector<double> expected = expectedCounts(probe(in), sphereQuadrature(true), n),
                              coarse = expectedCounts(sampled, sphereQuadrature(), n);
    double unresolved = 0;
    for (size_t i = 0; i < expected.size(); ++i)
        unresolved += (coarse[i] - expected[i]) * (coarse[i] - expected[i]) / std::max(expected[i], 5.0);
    const ChiSquare chi = testChiSquare(sampleCounts(sampled), expected);
    return unresolved > 0.05 * chi.degrees ? "" : fmt::format("{:.3f}", chi.probability);
}

/// Energy: the mean of weight * eta^2. p: of the chi-square test. Reciprocity: the largest relative difference.
std::string cell(const BsdfProbe& probe, const std::vector<uint>& b, float cosine, Random& random) {
    const vec3 wo = atCosine(cosine, 0.3f);
    BsdfInputs in;
    for (vec3 direction : sphereQuadrature().directions) in.add(b, wo, direction, random);
    const std::vector<BsdfResult> results = probe(in);
    double energy = 0, difference = 0;
    for (const BsdfResult& r : results) {
        const double squeeze = static_cast<double>(r.eta) * r.eta;
        energy += largest(r.weight) * squeeze / static_cast<double>(results.size());
        if (largest(r.weight) == 0 || std::fabs(r.wi.z) < 1e-2f || largest(r.fBack) == 0) continue;
        difference = std::max(difference, std::fabs(largest(r.f) * squeeze / largest(r.fBack) - 1));
    }
    const BsdfResult& one = results.front();
    const bool hasDensity = !one.kindIsDelta && !one.isRandom;
    return fmt::format(",{:.4f},{},{}", energy, hasDensity ? probability(probe, b, wo, results, random) : "",
                       hasDensity && !one.isOneWay ? fmt::format("{:.0e}", difference) : "");
}

TEST(BsdfTable, DISABLED_IsWritten) {
    const char* file = std::getenv("EIKONAL_BSDF_TABLE");
    ASSERT_NE(file, nullptr);
    std::ofstream out(file);
    for (const BsdfKind& kind : bsdfKinds()) {
        if (kind.spectral) continue;
        const BsdfProbe probe(kind);
        Random random{1};
        const bool isRough = std::ranges::any_of(kind.parameters, isWidth);
        const bool refracts = std::ranges::any_of(kind.parameters, isIndex);
        for (float eta : refracts ? tableIndices : std::vector<float>{1})
            for (float alpha : isRough ? tableWidths : std::vector<float>{1}) {
                const auto valueOf = [&](const BsdfParameter& p) { return whiteValue(p, alpha, eta); };
                const std::vector<uint> b = parametersOf(kind, valueOf);
                const std::string index = refracts ? fmt::format("{:.3g}", eta) : "", width = isRough ? fmt::format("{:g}", alpha) : "";
                out << kind.name << ',' << index << ',' << width;
                for (float cosine : {0.999f, 0.7f, 0.2f}) out << cell(probe, b, cosine, random);
                out << '\n';
            }
    }
    EXPECT_TRUE(out.good());
}

}  // namespace
}  // namespace eikonal
