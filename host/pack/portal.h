#pragma once
// The image of an infinite light as it is seen through a portal (kernels/light/portal_infinite.clh).

#include "eikonal/light.h"

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace eikonal {

/// An image over angles along the sides of a rectangle: of texel (x, y) at y resolution + x, the direction of its middle is
/// tan(pi ((x + 1/2) / resolution - 1/2)) along the first side, the same of y along the second, and 1 along the normal.
struct PortalImage {
    int resolution = 1;
    std::vector<glm::dvec3> texels;   ///< radiance
    std::vector<uint> sums;  ///< (resolution + 1)^2: of the weights of all texels with smaller x and y; at most 2^30 + resolution^2
    double fluence = 0;               ///< luminance integrated over the hemisphere
};

/// Of the environment that gives the radiance from a unit vector in the rectangle's frame. A texel's weight follows its radiance and
/// the solid angle that it covers; it is positive wherever the radiance is.
PortalImage makePortalImage(int resolution, const std::function<glm::dvec3(glm::dvec3 direction)>& radiance);

}  // namespace eikonal
