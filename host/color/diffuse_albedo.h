#pragma once
// Diffuse albedo of a deep scattering body as a function of its medium, and the inverse.

#include <vector>

namespace eikonal {

/// The albedo of a half-space below a smooth dielectric boundary: the share of light, sent into it perpendicularly, that leaves it through
/// the boundary. Internal reflection at the boundary is included, external reflection is not. rho: single-scattering albedo in [0, 1]; g:
/// mean cosine of Henyey and Greenstein's phase function, in (-1, 1); eta: index inside over outside, > 0. Discrete ordinates by adding and
/// doubling (van de Hulst 1980; Prahl 1995, "The Adding-Doubling Method").
double diffuseAlbedo(double rho, double g, double eta);

/// The same without a boundary, for diffuse light, in closed form and within 0.02: rho may be any number, and is clamped to [0, 1] (van de
/// Hulst 1980).
double halfSpaceAlbedo(double rho, double g);

/// The transmittance of a smooth dielectric boundary for diffuse light. eta: index on the far side over this side.
double boundaryTransmittance(double eta);

/// The inverse: the single-scattering albedo of a half-space with a given diffuse albedo.
class DiffuseAlbedoTable {
public:
    DiffuseAlbedoTable(double g, double eta);
    /// diffuse: clamped to [0, 1]. For eta up to 1.5, `diffuseAlbedo` of the result is within 0.001 of `diffuse`.
    double singleScattering(double diffuse) const;
    /// The diffuse albedo for a single-scattering albedo in [0, 1].
    double diffuse(double singleScattering) const;
    /// The values that `diffuse` interpolates, over van de Hulst's similarity parameter sqrt((1 - rho) / (1 - g rho)) = 1 - i / (size - 1).
    const std::vector<double>& albedos() const { return albedos_; }

private:
    double g_;
    std::vector<double> albedos_;
};

}  // namespace eikonal
