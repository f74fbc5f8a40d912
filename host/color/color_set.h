#pragma once
// The colours that a thing of the scene has, with their shares of it.

#include "color/dual_color.h"

#include <functional>
#include <vector>

namespace eikonal {

struct SharedColor { DualColor color; double share = 1; };
using ColorSet = std::vector<SharedColor>;

/// No set keeps more colours than this: the largest shares.
constexpr std::size_t mostColors = 48;

/// The colours of both, each set with a share of the whole.
ColorSet unite(const ColorSet& a, double shareOfA, const ColorSet& b, double shareOfB);
/// f of each pair of colours, as if the two were independent.
ColorSet combine(const ColorSet& a, const ColorSet& b, const std::function<DualColor(const DualColor&, const DualColor&)>& f);
/// f of each colour.
ColorSet map(const ColorSet& set, const std::function<DualColor(const DualColor&)>& f);
/// The mean colour; zero for an empty set.
DualColor meanOf(const ColorSet& set);
/// Of linear sRGB texels: similar ones are put together, as one texel of their mean. isLight: radiance, whose shares are of the whole
/// light, and whose mean is that of the texels.
ColorSet colorsOf(const std::vector<glm::dvec3>& texels, bool isLight);

}  // namespace eikonal
