#pragma once
// Equal-area mapping of the sphere to the square: Clarberg, "Fast equal-area mapping of the (hemi)sphere using SIMD", Journal of Graphics
// Tools 13(3), 2008. As in pbrt-v4's environment maps, the centre of the square is +z, its corners are -z, u grows with x and v with y.

#include "image/image_data.h"

#include <glm/glm.hpp>

#include <functional>

namespace eikonal {

/// The unit direction of a point in [0, 1]^2.
glm::dvec3 directionFromSquare(glm::dvec2 p);

/// The z of that direction, which takes no trigonometry.
double heightFromSquare(glm::dvec2 p);

/// The point in [0, 1]^2 of a direction, which need not be normalised but must not be zero.
glm::dvec2 squareFromDirection(glm::dvec3 d);

/// The texel of a square image, resolution x resolution, where the sphere goes on beyond an edge. texel: at most `resolution` outside.
glm::ivec2 wrapTexelOfSquare(glm::ivec2 texel, int resolution);

/// Texels of a square image, and the points in each: samples x samples. Row y, column x covers v in [y, y+1] / resolution and u in
/// [x, x+1] / resolution.
struct SquareGrid { int resolution, samples; };
/// The mean of a function of [0, 1]^2 over the points of a texel.
glm::dvec3 texelOfSquare(const SquareGrid& grid, int x, int y, const std::function<glm::dvec3(glm::dvec2 point)>& radiance);

/// A square image of the radiance from all directions (linear sRGB), of the texels of SquareGrid.
ImageData equalAreaImage(int resolution, int samples, const std::function<glm::dvec3(glm::dvec3 direction)>& radiance);

/// Resamples a latitude-longitude image, in which z is up, row 0 is +z, and columns run from +x through +y. resolution 0: the smallest
/// power of two that keeps at least as many texels.
ImageData equalAreaFromLatLong(const ImageData& latLong, int resolution = 0);

}  // namespace eikonal
