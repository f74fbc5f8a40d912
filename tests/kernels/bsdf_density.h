#pragma once
// Whether samples of a BSDF follow its density: by a chi-square test over cells of the sphere.

#include "bsdf_probe.h"
#include "statistics.h"

#include <algorithm>

namespace eikonal {

inline double largest(spectrum s) { return std::max({s.r, s.g, s.b}); }
vec3 atCosine(float cosine, float phi);

/// Gauss-Legendre over each cell of the sphere: points^2 directions with their weights.
struct Quadrature { std::vector<vec3> directions; std::vector<double> weights; };
const Quadrature& sphereQuadrature();

/// integral: of the density. kept: the fraction of samples that are not absorbed.
struct SampledDensity { double integral = 0, kept = 0; ChiSquare chi; };
/// results: for one wo, one for each direction of sphereQuadrature(), as `given`.
SampledDensity compareWithDensity(const std::vector<BsdfResult>& results);

}  // namespace eikonal
