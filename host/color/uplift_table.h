#pragma once
// The table of smooth reflectances that was fitted at build time (fit_uplift.cpp).

#include "color/uplift.h"

#include <span>

namespace eikonal {

/// The result of fitUpliftTable.
std::span<const float> upliftTable();

/// The smooth reflectance of an sRGB colour with components in [0, 1], interpolated in the table: accurate to about 0.002, at worst 0.008.
SmoothReflectance tabulatedReflectance(glm::dvec3 rgb);

}  // namespace eikonal
