#pragma once
// How much of a scene a view shows: a small depth buffer.

#include "read/obj/view.h"

#include <vector>

namespace eikonal {

/// The mean, over the shapes, of the fraction of their area that the view shows (as seen through a square image of 96 x 96 pixels):
/// area seen from the front counts 1, from behind behindCredit. In [0, 1].
double visibleFraction(const std::vector<ViewedTriangle>& triangles, const View& view, double behindCredit);

}  // namespace eikonal
