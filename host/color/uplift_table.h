#pragma once
// The table of smooth reflectances that was fitted when the program was built (fit_uplift.cpp).

#include "color/uplift.h"

#include <span>

namespace eikonal {

/// What fitUpliftTable found.
std::span<const float> upliftTable();

/// The smooth reflectance of an sRGB colour with components in [0, 1], between those of the table: to about 0.002, 0.008 at worst.
SmoothReflectance tabulatedReflectance(glm::dvec3 rgb);

}  // namespace eikonal
