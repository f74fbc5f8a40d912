#include "bsdf_density.h"

#include <cmath>
#include <numeric>

namespace eikonal {

vec3 atCosine(float cosine, float phi) {
    const float r = std::sqrt(1 - cosine * cosine);
    return {r * std::cos(phi), r * std::sin(phi), cosine};
}

namespace {

/// Cells of the sphere: equal steps of the cosine and of the azimuth, so all have the same area, and the horizon is an edge.
constexpr int rows = 32, columns = 64, points = 6;

int cellOf(vec3 w) {
    const int row = std::clamp(static_cast<int>((static_cast<double>(w.z) + 1) / 2 * rows), 0, rows - 1);
    const double turn = std::atan2(static_cast<double>(w.y), static_cast<double>(w.x)) / (2 * M_PI);
    return row * columns + std::clamp(static_cast<int>((turn < 0 ? turn + 1 : turn) * columns), 0, columns - 1);
}

}  // namespace

static Quadrature makeQuadrature(int parts) {
    constexpr double x[points] = {-0.9324695142031521, -0.6612093864662645, -0.2386191860831969,
                                  0.2386191860831969,  0.6612093864662645,  0.9324695142031521};
    constexpr double w[points] = {0.1713244923791704, 0.3607615730481386, 0.4679139345726910,
                                  0.4679139345726910, 0.3607615730481386, 0.1713244923791704};
    Quadrature made;
    const double area = 4 * M_PI / (rows * columns * parts * parts);
    const int side = points * parts;
    const auto within = [&](int k) { return (k / points + (x[k % points] + 1) / 2) / parts; };
    for (int cell = 0; cell < rows * columns; ++cell)
        for (int k = 0; k < side * side; ++k) {
            const int up = k / side, around = k % side;
            const double z = (cell / columns + within(up)) * 2 / rows - 1, phi = (cell % columns + within(around)) * 2 * M_PI / columns;
            const double r = std::sqrt(1 - z * z);
            made.directions.push_back(
                {static_cast<float>(r * std::cos(phi)), static_cast<float>(r * std::sin(phi)), static_cast<float>(z)});
            made.weights.push_back(area * w[up % points] * w[around % points] / 4);
        }
    return made;
}
const Quadrature& sphereQuadrature(bool fine) {
    static const Quadrature plain = makeQuadrature(1);
    if (!fine) return plain;
    static const Quadrature finer = makeQuadrature(2);
    return finer;
}

std::vector<double> expectedCounts(const std::vector<BsdfResult>& results, const Quadrature& q, double n) {
    std::vector<double> expected(rows * columns + 1);
    const size_t each = results.size() / (rows * columns);
    double integral = 0;
    for (size_t i = 0; i < results.size(); ++i) {
        const double p = q.weights[i] * static_cast<double>(results[i].pdfGiven);
        expected[i / each] += p * n;
        integral += p;
    }
    expected.back() = std::max(1 - integral, 0.0) * n;
    return expected;
}

std::vector<double> sampleCounts(const std::vector<BsdfResult>& results) {
    std::vector<double> counts(rows * columns + 1);
    for (const BsdfResult& r : results) counts[largest(r.weight) > 0 ? static_cast<size_t>(cellOf(r.wi)) : rows * columns] += 1;
    return counts;
}

SampledDensity compareWithDensity(const std::vector<BsdfResult>& results) {
    const double n = static_cast<double>(results.size());
    const std::vector<double> counts = sampleCounts(results), expected = expectedCounts(results, sphereQuadrature(), n);
    SampledDensity d;
    d.integral = std::accumulate(expected.begin(), expected.end() - 1, 0.0) / n;
    d.kept = 1 - counts.back() / n;
    d.chi = testChiSquare(counts, expected);
    return d;
}

}  // namespace eikonal
