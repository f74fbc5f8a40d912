#pragma once
// Measured scattering coefficients of everyday substances.

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace eikonal::pbrt {

/// Coefficients per mm, in linear sRGB.
struct MediumPreset { const char* name; glm::dvec3 reducedSigmaS, sigmaA; };

/// The substance called `name`; null if there is none.
const MediumPreset* mediumPreset(const std::string& name);
std::vector<std::string> mediumPresetNames();

}  // namespace eikonal::pbrt
