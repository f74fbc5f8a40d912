#pragma once
// The image of an infinite light seen through a portal (kernels/light/portal_infinite.clh).

#include "eikonal/portable.h"

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace eikonal {

/// An image over the angles along the sides of a rectangle. The centre of texel (x, y), at index y resolution + x, has the direction
/// tan(pi ((x + 1/2) / resolution - 1/2)) along the first side, the same with y along the second, and 1 along the normal.
struct PortalImage {
    int resolution = 1;
    std::vector<glm::dvec3> texels;   ///< radiance
    std::vector<uint> sums;  ///< (resolution + 1)^2: summed-area table of the texels' weights; at most 2^30 + resolution^2
    double fluence = 0;               ///< luminance integrated over the hemisphere
};

/// The image of an environment, whose radiance is given for unit vectors in the rectangle's frame. A texel's weight is proportional to its
/// radiance and solid angle, and positive wherever the radiance is.
PortalImage makePortalImage(int resolution, const std::function<glm::dvec3(glm::dvec3 direction)>& radiance);

}  // namespace eikonal
