// Fresnel's equations and refraction against double precision with complex numbers.

#include "device_function.h"
#include "random_inputs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace eikonal {
namespace {

/// Reflectance for unpolarised light at a boundary of relative index eta + i k (Born and Wolf, section 1.5.2), cosine in [0, 1].
double reflectance(double cosine, std::complex<double> eta) {
    const std::complex<double> sin2 = (1 - cosine * cosine) / (eta * eta), t = std::sqrt(1.0 - sin2);
    const std::complex<double> parallel = (eta * cosine - t) / (eta * cosine + t), perpendicular = (cosine - eta * t) / (cosine + eta * t);
    return (std::norm(parallel) + std::norm(perpendicular)) / 2;
}

struct Fresnel { float dielectric, conductor; };

struct Inputs { std::vector<float> cosine, eta, k; };
Inputs inputs() {
    Inputs in;
    Random random(31);
    for (int i = 0; i < 20000; ++i) {
        const float edges[] = {0, 1e-6f, 1e-3f, 0.5f, 1};
        in.cosine.push_back(random.below(4) ? random.between(-1, 1) : edges[random.below(5)]);
        in.eta.push_back(random.below(4) ? random.between(0.3f, 3) : 1 + random.between(-1e-3f, 1e-3f));
        in.k.push_back(random.below(4) ? random.between(0, 8) : 0);
    }
    return in;
}

const std::vector<Fresnel>& onDevice() {
    static const std::vector<Fresnel> results = [] {
        const DeviceFunction<Fresnel> function(
            {.include = "bsdf/fresnel.clh",
             .type = "fresnel",
             .body = "result.dielectric = fresnel_dielectric(cosine, eta); result.conductor = fresnel_conductor(fabs(cosine), eta, k);",
             .inputs = {"float cosine", "float eta", "float k"},
             .declarations = "typedef struct { float dielectric, conductor; } fresnel;"});
        const Inputs in = inputs();
        return function(in.cosine, in.eta, in.k);
    }();
    return results;
}

/// Also from inside (a negative cosine), where the index is inverted and reflection can be total.
TEST(Fresnel, DielectricIsAccurate) {
    const Inputs in = inputs();
    for (size_t i = 0; i < in.cosine.size(); ++i) {
        const double c = in.cosine[i], eta = c < 0 ? 1 / static_cast<double>(in.eta[i]) : static_cast<double>(in.eta[i]);
        /* At the critical angle a rounding of the sine moves the reflectance by its square root */
        const double sin2 = (1 - c * c) / (eta * eta), tolerance = 2e-6 + 4e-6 / std::sqrt(std::max(std::abs(1 - sin2), 1e-7));
        ASSERT_NEAR(onDevice()[i].dielectric, sin2 >= 1 ? 1 : reflectance(std::abs(c), eta), tolerance)
            << "cosine " << c << " eta " << in.eta[i];
    }
}

TEST(Fresnel, ConductorIsAccurate) {
    const Inputs in = inputs();
    for (size_t i = 0; i < in.cosine.size(); ++i) {
        const double c = std::abs(static_cast<double>(in.cosine[i])), eta = in.eta[i], k = in.k[i];
        const double sin2 = (1 - c * c) / (eta * eta),
                     tolerance = k > 0.05 ? 1e-5 : 1e-5 + 1e-5 / std::sqrt(std::max(std::abs(1 - sin2), 1e-6));
        ASSERT_NEAR(onDevice()[i].conductor, reflectance(c, {eta, k}), tolerance) << "cosine " << c << " eta " << eta << " k " << k;
    }
}

/// Reflectance in long double, as the difference of products that cancels where the index is close to 1; there its 64 bits leave at least
/// 64 - 2 * 20 of them for an index within 1e-6 of 1.
long double longReflectance(long double c, std::complex<long double> n) {
    const std::complex<long double> w = std::sqrt(n * n - (1 - c * c));
    const auto parallel = (n * n * c - w) / (n * n * c + w), perpendicular = (c - w) / (c + w);
    return (std::norm(parallel) + std::norm(perpendicular)) / 2;
}

/// An index 1 + x + i y with x and y from 1e-6 up, or 0, seen from outside: about 20 roundings of 2^-24, none of them amplified.
TEST(Fresnel, IndicesCloseToOneKeepTheirRelativeAccuracy) {
    const DeviceFunction<Fresnel> function(
        {.include = "bsdf/fresnel.clh",
         .type = "fresnel",
         .body = "result.dielectric = fresnel_dielectric(cosine, eta); result.conductor = fresnel_conductor(cosine, eta, k);",
         .inputs = {"float cosine", "float eta", "float k"},
         .declarations = "typedef struct { float dielectric, conductor; } fresnel;"});
    Inputs in;
    Random random(33);
    for (int i = 0; i < 20000; ++i) {
        const float cosines[] = {1e-6f, 1e-3f, 0.5f, 1};
        const auto offset = [&] { return random.below(4) ? std::pow(10.0f, random.between(-6, 0.5f)) : 0.0f; };
        in.cosine.push_back(random.below(4) ? random.between(0, 1) : cosines[random.below(4)]);
        in.eta.push_back(1 + offset());
        in.k.push_back(offset());
    }
    const auto results = function(in.cosine, in.eta, in.k);
    for (size_t i = 0; i < results.size(); ++i) {
        const long double c = in.cosine[i], metal = longReflectance(c, {in.eta[i], in.k[i]}), glass = longReflectance(c, {in.eta[i], 0});
        const auto where = testing::Message() << "cosine " << in.cosine[i] << " eta " << in.eta[i] << " k " << in.k[i];
        ASSERT_NEAR(results[i].conductor, static_cast<double>(metal), static_cast<double>(metal) * 20 / (1 << 24) + 1e-19) << where;
        ASSERT_NEAR(results[i].dielectric, static_cast<double>(glass), static_cast<double>(glass) * 20 / (1 << 24) + 1e-19) << where;
    }
}

/// What passes of diffuse light is the mean of 1 - F over the cosine-weighted hemisphere, here by Simpson's rule.
TEST(Fresnel, DiffuseTransmittanceIsTheMean) {
    const DeviceFunction<float> function(
        {.include = "bsdf/fresnel.clh", .type = "float", .body = "result = diffuse_transmittance(eta);", .inputs = {"float eta"}});
    std::vector<float> eta;
    for (int i = 0; i <= 60; ++i) eta.push_back(std::exp(std::log(3.0f) * static_cast<float>(i - 30) / 30));
    const auto results = function(eta);
    constexpr int steps = 20000;
    for (size_t k = 0; k < eta.size(); ++k) {
        double mean = 0;
        for (int i = 0; i < steps; ++i) {
            /* The square of the cosine is what is uniform */
            const double c = std::sqrt((i + 0.5) / steps), e = eta[k];
            mean += (1 - c * c >= e * e ? 0 : 1 - reflectance(c, e)) / steps;
        }
        EXPECT_NEAR(results[k], mean, 1e-3 * std::max(1.0, static_cast<double>(eta[k]) * eta[k])) << "eta " << eta[k];
    }
}

/// Snell's law in any orientation: the refracted direction has unit length, lies in the plane of incidence on the other side, its
/// sine is that of w over the relative index, and it is absent exactly when that sine exceeds one.
TEST(Fresnel, RefractionObeysSnell) {
    struct Refraction { vec3 w; float eta; int ok; };
    const DeviceFunction<Refraction> function({.include = "bsdf/fresnel.clh",
                                               .type = "refraction",
                                               .body = "result = refract_direction(w, n, eta);",
                                               .inputs = {"vec3 w", "vec3 n", "float eta"}});
    Random random(32);
    const size_t n = 20000;
    const auto w = generate(n, [&] { return random.direction(); }), normal = generate(n, [&] { return random.direction(); });
    const auto eta = generate(n, [&] { return random.between(0.4f, 2.5f); });
    const auto results = function(w, normal, eta);
    for (size_t i = 0; i < n; ++i) {
        const double c = dot(w[i], normal[i]), e = c < 0 ? 1 / static_cast<double>(eta[i]) : static_cast<double>(eta[i]),
                     sine = std::sqrt(1 - c * c) / e;
        if (std::abs(sine - 1) < 1e-5) continue;
        ASSERT_EQ(results[i].ok != 0, sine < 1) << "cosine " << c << " eta " << eta[i];
        if (!results[i].ok) continue;
        const vec3 t = results[i].w;
        const double ct = dot(t, normal[i]);
        ASSERT_NEAR(results[i].eta, e, 1e-5 * e);
        ASSERT_NEAR(dot(t, t), 1, 1e-5);
        ASSERT_LT(ct * c, 1e-12);
        /* The part along the surface is that of -w, divided by the index */
        for (auto axis : {&vec3::x, &vec3::y, &vec3::z})
            ASSERT_NEAR(t.*axis - ct * normal[i].*axis, -(w[i].*axis - c * normal[i].*axis) / e, 2e-6);
    }
}

}  // namespace
}  // namespace eikonal
