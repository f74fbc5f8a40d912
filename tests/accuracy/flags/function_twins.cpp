#include "flags/function_twins.h"

#include "kernels/device_function.h"
#include "kernels/random_inputs.h"

#include <complex>
#include <functional>

namespace eikonal {
namespace {

using Wide = long double;

/// A function of three floats: OpenCL C that sets `result`, where its inputs lie, and the same in long double.
struct Twin {
    const char *name, *include, *body;
    std::function<float(Random&)> x, y, z;
    std::function<Wide(Wide x, Wide y, Wide z)> twin;
};

std::function<float(Random&)> between(float low, float high) {
    return [=](Random& random) { return random.between(low, high); };
}
std::function<float(Random&)> octaves(float low, float high) {
    return [=](Random& random) { return random.logBetween(low, high); };
}

/// Reflectance for unpolarised light at the boundary to index n (Born and Wolf, section 1.5.2).
Wide reflectance(Wide cosine, std::complex<Wide> n) {
    const std::complex<Wide> w = std::sqrt(n * n - (1 - cosine * cosine));
    const auto parallel = (n * n * cosine - w) / (n * n * cosine + w), perpendicular = (cosine - w) / (cosine + w);
    return (std::norm(parallel) + std::norm(perpendicular)) / 2;
}

Wide ggx(Wide cosine, Wide alpha) {
    const Wide a2 = alpha * alpha, t = cosine * cosine * (a2 - 1) + 1;
    return a2 / (static_cast<Wide>(M_PIl) * t * t);
}

const std::vector<Twin>& twins() {
    static const std::vector<Twin> all{
        {"x / y", "math/functions.clh", "result = x / y;", between(-2, 2), octaves(1e-6f, 1e6f), between(0, 1),
         [](Wide x, Wide y, Wide) { return x / y; }},
        {"sqrt", "math/functions.clh", "result = sqrt(x);", octaves(1e-10f, 1e10f), between(0, 1), between(0, 1),
         [](Wide x, Wide, Wide) { return sqrtl(x); }},
        {"x y + z", "math/functions.clh", "result = x * y + z;", between(0, 2), between(0, 2), between(0, 2),
         [](Wide x, Wide y, Wide z) { return x * y + z; }},
        {"length3", "math/vector.clh", "result = length3(make_vec3(x, y, z));", between(-2, 2), between(-2, 2), between(-2, 2),
         [](Wide x, Wide y, Wide z) { return sqrtl(x * x + y * y + z * z); }},
        {"normalize3", "math/vector.clh", "result = normalize3(make_vec3(x, y, z)).x;", between(-2, 2), between(-2, 2), between(-2, 2),
         [](Wide x, Wide y, Wide z) { return x / sqrtl(x * x + y * y + z * z); }},
        {"exp1", "math/functions.clh", "result = exp1(x);", between(-87, 87), between(0, 1), between(0, 1),
         [](Wide x, Wide, Wide) { return expl(x); }},
        {"log1", "math/functions.clh", "result = log1(x);", octaves(1e-30f, 0.5f), between(0, 1), between(0, 1),
         [](Wide x, Wide, Wide) { return logl(x); }},
        {"atan2_1", "math/functions.clh", "result = atan2_1(y, x);", between(-2, 2), between(-2, 2), between(0, 1),
         [](Wide x, Wide y, Wide) { return atan2l(y, x); }},
        {"asin1", "math/functions.clh", "result = asin1(x);", between(-1, 1), between(0, 1), between(0, 1),
         [](Wide x, Wide, Wide) { return asinl(x); }},
        {"scaled_bessel_i0", "math/functions.clh", "result = scaled_bessel_i0(x);", between(0, 80), between(0, 1), between(0, 1),
         [](Wide x, Wide, Wide) { return std::cyl_bessel_i(Wide(0), x) * expl(-x); }},
        {"fresnel_dielectric", "bsdf/fresnel.clh", "result = fresnel_dielectric(x, y);", between(0.01f, 1), between(1.1f, 3), between(0, 1),
         [](Wide x, Wide y, Wide) { return reflectance(x, y); }},
        {"fresnel_conductor", "bsdf/fresnel.clh", "result = fresnel_conductor(x, y, z);", between(0.01f, 1), between(0.2f, 3),
         between(1, 8),
         [](Wide x, Wide y, Wide z) {
             return reflectance(x, {y, z});
         }},
        {"eval_ggx", "bsdf/microfacet.clh", "result = eval_ggx(make_ggx(y, y), make_vec3(safe_sqrt((1.0f - x) * (1.0f + x)), 0.0f, x));",
         between(0.1f, 1), between(0.05f, 1), between(0, 1), [](Wide x, Wide y, Wide) { return ggx(x, y); }},
        {"compensated sum of 1000", "film/compensated.clh",
         "float c = 0.0f; result = 0.0f; for (int i = 0; i < 1000; i++) add_compensated(&result, &c, x);", between(0.1f, 1), between(0, 1),
         between(0, 1), [](Wide x, Wide, Wide) { return 1000 * x; }},
    };
    return all;
}

}  // namespace

std::vector<FunctionFigures> compareFunctions(const std::vector<std::string>& flagSets) {
    std::vector<FunctionFigures> figures;
    for (const Twin& twin : twins()) {
        Random random(14);
        std::vector<float> x, y, z;
        for (int i = 0; i < 100000; ++i) {
            x.push_back(twin.x(random));
            y.push_back(twin.y(random));
            z.push_back(twin.z(random));
        }
        std::vector<float> first;
        for (const std::string& flags : flagSets) {
            const DeviceFunction<float> function({.include = twin.include,
                                                  .type = "float",
                                                  .body = twin.body,
                                                  .inputs = {"float x", "float y", "float z"},
                                                  .mathFlags = flags});
            const std::vector<float> results = function(x, y, z);
            if (first.empty()) first = results;
            FunctionFigures f{twin.name, flags, {}, {}};
            for (size_t i = 0; i < results.size(); ++i) {
                const Wide exact = twin.twin(x[i], y[i], z[i]);
                const double unit = unitInLastPlace(static_cast<double>(exact));
                f.fromTwin.add(static_cast<double>(fabsl(results[i] - exact)) / unit);
                f.fromFirst.add(std::fabs(static_cast<double>(results[i]) - static_cast<double>(first[i])) / unit);
            }
            figures.push_back(f);
        }
    }
    return figures;
}

}  // namespace eikonal
