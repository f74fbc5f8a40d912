#pragma once
// Measures how much of a scene a view shows, with a small depth buffer.

#include "read/obj/view.h"

#include <vector>

namespace eikonal {

/// The mean over the shapes of the visible fraction of their area, in a square image of 96 x 96 pixels. Area seen from the front counts 1,
/// from behind behindCredit. In [0, 1]. Of very many large triangles, only the first are drawn and counted.
double visibleFraction(const std::vector<ViewedTriangle>& triangles, const View& view, double behindCredit);

}  // namespace eikonal
