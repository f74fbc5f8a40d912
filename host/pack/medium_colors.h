#pragma once
// The colours of media.

#include "color/dual_color.h"
#include "scene/media.h"

#include <vector>

namespace eikonal {

/// A part of a medium: coefficients per world unit.
struct MediumColor {
    DualColor sigmaA, sigmaS;
    double g = 0;
    /// What is seen of white light, over a path of this length: a background behind it, and light that it scatters.
    DualColor seen(const DualColor& background, double length) const;
};

/// Typical parts of a medium: where its density is the mean of what is not empty, and for grids of colours, different colours.
std::vector<MediumColor> colorsOf(const Medium& medium);

}  // namespace eikonal
