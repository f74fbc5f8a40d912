// Every BSDF of the list BSDFS has the properties that path tracing relies on. A new line in that list is tested without
// a new test. Directions as in kernels/bsdf/bsdf.clh.

#include "bsdf_density.h"
#include "kinds/material_kind.h"
#include "stage.h"
#include "statistics.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string_view>

namespace eikonal {
namespace {

constexpr float grazing[] = {1e-1f, 1e-2f, 1e-3f, 1e-5f};

/// A direction whose cosine is at least `lowest` in size, on either side.
vec3 drawDirection(Random& random, float lowest) {
    for (;;) {
        const vec3 w = random.direction();
        if (std::fabs(w.z) >= lowest) return w;
    }
}

std::array<double, 3> channels(spectrum s) { return {s.r, s.g, s.b}; }
bool finite(spectrum s) { return std::isfinite(s.r) && std::isfinite(s.g) && std::isfinite(s.b); }

std::string describe(vec3 v) { return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")"; }

class EveryBsdf : public testing::TestWithParam<BsdfKind> {
protected:
    const BsdfKind& kind() const { return GetParam(); }
    BsdfProbe probe{GetParam()};
    Random random{1};

    bool isRandom() { return one().isRandom; }
    bool isOneWay() { return one().isOneWay; }
    bool isDelta() { return one().kindIsDelta; }
    /// A point in a medium: its value goes without a cosine (kernels/shade/light_paths.clh).
    bool isInMedium() const { return kind().name == "henyey_greenstein"; }
    double cosineOf(const vec3& w) const { return isInMedium() ? 1 : std::fabs(static_cast<double>(w.z)); }
    BsdfResult one() {
        BsdfInputs in;
        in.add(drawParameters(kind(), Range::smooth, random), {0, 0, 1}, {0, 0, 1}, random);
        return probe(in).front();
    }
    /// n items, each with parameters and directions of its own.
    BsdfInputs various(size_t n, Range range, float lowest) {
        BsdfInputs in;
        for (size_t i = 0; i < n; ++i)
            in.add(drawParameters(kind(), range, random), drawDirection(random, lowest), random.direction(), random);
        return in;
    }
    std::string describeItem(const BsdfInputs& in, size_t i) const {
        const size_t w = in.parameters.words;
        return describeParameters(kind(), {in.parameters.data.begin() + static_cast<long>(i * w),
                                           in.parameters.data.begin() + static_cast<long>((i + 1) * w)}) +
               " wo " + describe(in.wo[i]) + " lobe " + std::to_string(in.lobe[i]) + " u " + std::to_string(in.u[i].x) + " " +
               std::to_string(in.u[i].y);
    }
};

/// The queues of the BSDFs whose materials say that they transmit light. Of rough materials, since delta distributions evaluate to 0.
std::set<uint> transmittingBsdfs() {
    std::set<uint> transmitting;
    for (const MaterialKind* kind : materialKindList()) {
        if (kind->directives.empty() || kind == &mix_material || kind == &measured_material) continue;  // no defaults to pack
        const MaterialDirective& directive = kind->directives.front();
        const auto has = [&](const char* text) { return std::string_view(directive.parameters).find(text) != std::string_view::npos; };
        for (const char* more : {"", "\"bool energycompensation\" true"}) {
            if (*more && !has("energycompensation")) continue;
            const PackedScene scene = packText(fmt::format("WorldBegin\nMaterial \"{}\" {} {}\nShape \"sphere\"\n", directive.name,
                                                           has("| roughness") ? "\"float roughness\" 0.3" : "", more),
                                               ColorMode::rgb);
            for (const material& m : scene.tables.materials)
                if (m.transmits) transmitting.insert(m.next_queue);
        }
    }
    return transmitting;
}

/// The light tree leaves out what is behind a surface, unless its material says that it transmits.
TEST_P(EveryBsdf, IsDarkFromBehindUnlessItTransmits) {
    static const std::set<uint> transmitting = transmittingBsdfs();
    bool known = false;
#define IS_KNOWN(bsdf, FEATURE, PARAMETERS) if (kind().name == #bsdf) known = transmitting.contains(next_##bsdf);
    BSDFS(IS_KNOWN)
#undef IS_KNOWN
    if (isInMedium()) known = true;   // nothing is behind it
    BsdfInputs in = various(4000, Range::smooth, 1e-2f);
    for (size_t i = 0; i < in.size(); ++i)
        if (in.given[i].z * in.wo[i].z > 0) in.given[i].z = -in.given[i].z;
    for (const BsdfResult& r : probe(in))
        ASSERT_TRUE(known || largest(r.fGiven) == 0) << "call InputWriter::transmit() where its material is packed";
}

/// The weight of a sample is eval * |cos| / pdf, and pdf_x says the same density as sample_x. Relative to 1 %: narrow lobes lose
/// digits when the facet is found again from the two directions.
TEST_P(EveryBsdf, WeighsSamplesByEvalCosineOverPdf) {
    if (isRandom()) GTEST_SKIP() << "eval is a random estimate; WeightsHaveTheMeanOfEval holds the means together";
    const BsdfInputs in = various(20000, Range::smooth, 1e-2f);
    const auto results = probe(in);
    int checked = 0;
    for (size_t i = 0; i < results.size(); ++i) {
        const BsdfResult& r = results[i];
        ASSERT_EQ(r.isDelta, r.kindIsDelta) << describeItem(in, i);
        ASSERT_NEAR(dot(r.wi, r.wi), 1, 1e-5) << describeItem(in, i);
        if (r.kindIsDelta) { EXPECT_EQ(largest(r.f), 0); EXPECT_EQ(r.pdfHere, 0); EXPECT_EQ(r.pdf, 0); ++checked; continue; }
        if (largest(r.weight) == 0) continue;
        ASSERT_GT(r.pdf, 0) << describeItem(in, i);
        /* A direction along the surface has neither a cosine nor a facet that can be found again */
        if (std::fabs(r.wi.z) < 1e-4f) continue;
        ASSERT_NEAR(r.pdfHere / r.pdf, 1, 1e-2) << describeItem(in, i) << " wi " << describe(r.wi) << " pdf " << r.pdf;
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(channels(r.f)[c] * cosineOf(r.wi) / r.pdf, channels(r.weight)[c], 1e-2 * channels(r.weight)[c] + 1e-6)
                << describeItem(in, i) << " wi " << describe(r.wi) << " channel " << c;
        ++checked;
    }
    EXPECT_GT(checked, 15000);
}

/// Light goes either way: f(wo, wi) = f(wi, wo), with radiance squeezed by the square of the index where it crosses a boundary
/// (Veach 1997, section 5.2): f(wo, wi) eta^2 = f(wi, wo), eta the index of wi's side over that of wo's.
TEST_P(EveryBsdf, IsReciprocal) {
    if (isRandom()) GTEST_SKIP() << "eval is a random estimate";
    if (isOneWay()) GTEST_SKIP() << "the model is not reciprocal";
    const BsdfInputs in = various(20000, Range::smooth, 1e-2f);
    const auto results = probe(in);
    for (size_t i = 0; i < results.size(); ++i) {
        const BsdfResult& r = results[i];
        if (r.kindIsDelta || largest(r.weight) == 0 || std::fabs(r.wi.z) < 1e-2f) continue;
        const double squeeze = static_cast<double>(r.eta) * r.eta;
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(channels(r.f)[c] * squeeze, channels(r.fBack)[c], 1e-2 * channels(r.fBack)[c] + 1e-6)
                << describeItem(in, i) << " wi " << describe(r.wi);
    }
}

// ---- densities ------------------------------------------------------------------------------------------------------

/// The pdf integrates to the probability that a sample is not absorbed (a facet's reflection that goes into the surface is: its
/// weight is zero), and the others fall into the cells of the sphere as often as the pdf says.
TEST_P(EveryBsdf, SamplesFollowTheirDensity) {
    if (isDelta()) GTEST_SKIP() << "a delta distribution has no density";
    if (isRandom()) GTEST_SKIP() << "the density of a random walk is only approximate, as pbrt-v4's is";
    for (int set = 0; set < 8; ++set) {
        BsdfInputs in;
        const std::vector<uint> b = drawParameters(kind(), Range::smooth, random);
        /* Both sides, straight on to fairly grazing */
        const vec3 wo = atCosine((set % 2 ? -1.0f : 1.0f) * (set < 2 ? 0.99f : random.between(0.15f, 1)), random.between(0, 6.28f));
        for (vec3 direction : sphereQuadrature().directions) in.add(b, wo, direction, random);
        const auto results = probe(in);
        const double n = static_cast<double>(results.size());

        const SampledDensity d = compareWithDensity(results);
        EXPECT_LE(d.integral, 1 + 2e-3) << describeItem(in, 0);
        EXPECT_NEAR(d.integral, d.kept, 4 * std::sqrt(d.kept * (1 - d.kept) / n) + 2e-3) << describeItem(in, 0);
        EXPECT_GT(d.chi.probability, significance) << d.chi.describe() << "\n" << describeItem(in, 0);
    }
}

// ---- energy -----------------------------------------------------------------------------------------------------------

/// For the same parameters and wo, the mean weight of samples is the albedo: the integral of eval * |cos|, estimated with
/// directions that are uniform over the sphere. They agree at four standard errors.
TEST_P(EveryBsdf, WeightsHaveTheMeanOfEval) {
    if (isDelta()) GTEST_SKIP() << "a delta distribution has nothing to evaluate";
    for (int set = 0; set < 6; ++set) {
        const std::vector<uint> b = drawParameters(kind(), Range::smooth, random);
        const vec3 wo = atCosine((set % 2 ? -1.0f : 1.0f) * random.between(0.2f, 1), random.between(0, 6.28f));
        BsdfInputs in;
        /* Random walks are noisier, and have hidden a bias of 5 % in fewer */
        const int samples = isRandom() ? 200000 : 40000;
        for (int i = 0; i < samples; ++i) in.add(b, wo, random.direction(), random);
        Accumulator sampled[3], uniform[3];
        const auto results = probe(in);
        for (size_t i = 0; i < results.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                sampled[c].add(channels(results[i].weight)[c]);
                uniform[c].add(channels(results[i].fGiven)[c] * cosineOf(in.given[i]) * 4 * M_PI);
            }
        for (int c = 0; c < 3; ++c) {
            const Estimate s = sampled[c].estimate(), u = uniform[c].estimate();
            EXPECT_NEAR(s.mean, u.mean, 4 * std::hypot(s.error, u.error) + 1e-4) << describeItem(in, 0) << " channel " << c;
        }
    }
}

/// No surface gives more light than it gets: the mean of weight * eta^2 (the squeeze of radiance undone) is at most one, at
/// four standard errors.
TEST_P(EveryBsdf, CreatesNoEnergy) {
    for (Range range : {Range::smooth, Range::extreme})
        for (int set = 0; set < 12; ++set) {
            const std::vector<uint> b = drawParameters(kind(), range, random);
            const vec3 wo = set < 4 ? atCosine(grazing[set], 1) : drawDirection(random, 1e-3f);
            BsdfInputs in;
            for (int i = 0; i < 10000; ++i) in.add(b, wo, {0, 0, 1}, random);
            Accumulator energy;
            for (const BsdfResult& r : probe(in)) energy.add(largest(r.weight) * static_cast<double>(r.eta) * static_cast<double>(r.eta));
            const Estimate e = energy.estimate();
            EXPECT_LE(e.mean, 1 + 4 * e.error + 1e-3) << describeItem(in, 0);
        }
}

// ---- edges --------------------------------------------------------------------------------------------------------------

/// At grazing angles, straight on, along the surface itself and with parameters at the ends of their ranges, all numbers are
/// finite, none is negative, and directions have unit length.
TEST_P(EveryBsdf, StaysFiniteAtTheEdges) {
    BsdfInputs in;
    const float edges[] = {0, 1e-30f, 0x1p-24f, 0.5f, 1 - 0x1p-24f};
    for (int i = 0; i < 40000; ++i) {
        const float cosine = random.below(2) ? grazing[random.below(4)] : random.below(4) ? 1.0f : 0.0f;
        const vec3 wo = atCosine(random.below(2) ? cosine : -cosine, random.between(0, 6.28f));
        const vec3 given = random.below(4) ? random.direction() : random.below(2) ? vec3{-wo.x, -wo.y, wo.z} : vec3{-wo.x, -wo.y, -wo.z};
        in.add(drawParameters(kind(), random.below(2) ? Range::extreme : Range::smooth, random), wo, given, random);
        if (random.below(2)) in.u.back() = {edges[random.below(5)], edges[random.below(5)]};
        if (random.below(4) == 0) in.lobe.back() = edges[random.below(5)];
    }
    const auto results = probe(in);
    for (size_t i = 0; i < results.size(); ++i) {
        const BsdfResult& r = results[i];
        const std::string what = describeItem(in, i) + " wi " + describe(r.wi) + " given " + describe(in.given[i]);
        for (const spectrum& s : {r.weight, r.f, r.fBack, r.fGiven}) {
            ASSERT_TRUE(finite(s)) << what;
            ASSERT_GE(std::min({s.r, s.g, s.b}), 0) << what;
        }
        for (float x : {r.pdf, r.pdfHere, r.pdfGiven}) {
            ASSERT_TRUE(std::isfinite(x)) << what;
            ASSERT_GE(x, 0) << what;
        }
        if (largest(r.weight) > 0) { ASSERT_NEAR(dot(r.wi, r.wi), 1, 1e-4) << what; }
        if (!r.isDelta && largest(r.weight) > 0) { ASSERT_GT(r.pdf, 0) << what; }
    }
}

/// A delta distribution mirrors, refracts by Snell's law or lets pass: the part of wi along the surface is that of -wo over the
/// relative index. No weight is above one (undoing the squeeze of radiance).
TEST_P(EveryBsdf, MirrorsAndRefractsExactly) {
    if (!isDelta()) GTEST_SKIP() << "not a delta distribution";
    const BsdfInputs in = various(20000, Range::smooth, 1e-3f);
    const auto results = probe(in);
    for (size_t i = 0; i < results.size(); ++i) {
        const BsdfResult& r = results[i];
        if (largest(r.weight) == 0) continue;
        ASSERT_NEAR(r.wi.x * r.eta, -in.wo[i].x, 2e-6) << describeItem(in, i);
        ASSERT_NEAR(r.wi.y * r.eta, -in.wo[i].y, 2e-6) << describeItem(in, i);
        if (r.eta != 1) { ASSERT_LT(r.wi.z * in.wo[i].z, 0) << describeItem(in, i); }
        ASSERT_LE(largest(r.weight) * static_cast<double>(r.eta) * static_cast<double>(r.eta), 1 + 1e-5) << describeItem(in, i);
    }
}

/// What trees of rays go by: below the split it reflects, above it transmits.
TEST_P(EveryBsdf, SplitsBetweenReflectionAndTransmission) {
    if (!isDelta()) GTEST_SKIP() << "not a delta distribution";
    const BsdfInputs in = various(20000, Range::smooth, 1e-3f);
    const auto results = probe(in);
    for (size_t i = 0; i < results.size(); ++i) {
        const BsdfResult& r = results[i];
        ASSERT_GE(r.split, 0) << describeItem(in, i);
        ASSERT_LE(r.split, 1) << describeItem(in, i);
        if (largest(r.weight) == 0) continue;
        ASSERT_EQ(r.wi.z * in.wo[i].z > 0, in.lobe[i] < r.split) << describeItem(in, i);
    }
}

INSTANTIATE_TEST_SUITE_P(Bsdfs, EveryBsdf, testing::ValuesIn(bsdfKinds()),
                         [](const auto& info) { return info.param.name + (info.param.spectral ? "_spectral" : ""); });

}  // namespace
}  // namespace eikonal
