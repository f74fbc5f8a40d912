#pragma once
// How much of the light that has entered a deep body leaves it again, and what the body must be made of for that.

#include <vector>

namespace eikonal {

/// The albedo of a half-space below a smooth dielectric boundary: the share of light, sent into it perpendicularly, that leaves it again
/// through the boundary, which reflects a part of what comes from inside. What the boundary reflects from outside is not in it.
/// rho: single-scattering albedo in [0, 1]; g: mean cosine of Henyey and Greenstein's phase function, in (-1, 1); eta: index inside over
/// outside, > 0. Discrete ordinates by adding and doubling (van de Hulst 1980; Prahl 1995, "The Adding-Doubling Method").
double diffuseAlbedo(double rho, double g, double eta);

/// The share of light that falls evenly from all sides on a smooth dielectric boundary which passes it. eta: index beyond over this side.
double boundaryTransmittance(double eta);

/// The way back: the single-scattering albedo of a half-space of a given diffuse albedo.
class DiffuseAlbedoTable {
public:
    DiffuseAlbedoTable(double g, double eta);
    /// diffuse: in [0, 1], numbers outside count as the nearest end. Error below 0.001 in what `diffuseAlbedo` makes of the result, for eta up to 1.5.
    double singleScattering(double diffuse) const;
    /// The diffuse albedo for a single-scattering albedo in [0, 1].
    double diffuse(double singleScattering) const;
    /// What `diffuse` interpolates: over van de Hulst's similarity parameter, sqrt((1 - rho) / (1 - g rho)) = 1 - i / (size - 1).
    const std::vector<double>& albedos() const { return albedos_; }

private:
    double g_;
    std::vector<double> albedos_;
};

}  // namespace eikonal
