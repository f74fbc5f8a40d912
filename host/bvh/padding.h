#pragma once
// The padding of node boxes, so that no ray that hits an element misses the box around it.

#include "bvh/box.h"
#include "eikonal/bvh.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

/* Let u = 2^-24, p a plane, v a corner of a triangle, o the ray's origin, and |.| the largest coordinate of a point.

   The slab test (kernels/trace/bvh.clh) computes, to first order in u with every |e| <= u (e4 = 0 if the device fuses),
       inverse = (1 + e1) / d,   o_inverse = (1 + e2) o inverse,   t = (1 + e3) ((1 + e4) p inverse - o_inverse),
       so t d = (1 + e1 + e3) (p - o) + e4 p - e2 o:
   the exact distance to a plane that is displaced by at most u (2 |p - o| + |p| + |o|) <= 3 u (|p| + |o|).

   The triangle test (kernels/shape/triangle.clh) may accept a ray that narrowly misses the triangle. With D = |v - o|, a sheared
   corner  (vx - ox) - shear_x (vz - oz)  is off by at most u D for each of: the two differences, the product, and twice that for
   the last subtraction, whose result is up to 2 D; the shear itself, rounded twice, is that of a ray 2 u D away; the
   products of an edge function round like corners that are displaced by u 2 D. All of it: (5 + 2 + 2) u D <= 9 u (|v| + |o|).

   So planes must move out by 12 u (|box| + |o|). The builder moves them by 16 u |box|, traversal by 16 u |o|: the difference
   covers the rounding of these additions and the terms of second order (prepare_ray). Both are relative to the largest
   coordinate, not to each axis' own, because the shear mixes the axes. */

/// The largest absolute coordinate of a box.
inline float largestCoordinate(const WideBox& box) {
    float largest = 0;
    for (int axis = 0; axis < 3; ++axis) largest = std::max({largest, std::fabs(box.low[axis]), std::fabs(box.high[axis])});
    return largest;
}

/// The padded box that a node stores for `box`. Padded parents contain their padded children.
inline WideBox padBox(WideBox box) {
    const float pad = BOX_PADDING * largestCoordinate(box);
    box.low -= pad;
    box.high += pad;
    return box;
}

}  // namespace eikonal
