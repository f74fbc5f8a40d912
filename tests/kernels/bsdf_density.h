#pragma once
// Whether samples of a BSDF follow its density: by a chi-square test over cells of the sphere.

#include "bsdf_probe.h"
#include "statistics.h"

#include <algorithm>

namespace eikonal {

inline double largest(spectrum s) { return std::max({s.r, s.g, s.b}); }
vec3 atCosine(float cosine, float phi);

/// Gauss-Legendre over each cell of the sphere: directions with their weights, cell by cell. fine: over each quarter of the cells.
struct Quadrature { std::vector<vec3> directions; std::vector<double> weights; };
const Quadrature& sphereQuadrature(bool fine = false);

/// How many samples are in each cell; the last: absorbed.
std::vector<double> sampleCounts(const std::vector<BsdfResult>& results);
/// integral: of the density. kept: the fraction of samples that are not absorbed.
struct SampledDensity { double integral = 0, kept = 0; ChiSquare chi; };
/// How many samples are expected in each cell, of n; the last: absorbed. results: for one wo, one for each direction of a quadrature.
std::vector<double> expectedCounts(const std::vector<BsdfResult>& results, const Quadrature& q, double n);
/// results: for one wo, one for each direction of sphereQuadrature(), as `given`.
SampledDensity compareWithDensity(const std::vector<BsdfResult>& results);

}  // namespace eikonal
