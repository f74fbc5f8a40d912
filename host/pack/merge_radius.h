#pragma once
// Chooses the radius within which paths from both ends merge at first, by what the camera sees and where light paths go.

#include "eikonal/portable.h"

#include <optional>
#include <vector>

namespace eikonal {

/// Points on surfaces, with unit normals.
struct SurfacePoints { std::vector<vec3> points, normals; };

/// What a first look at a scene tells. Scene units.
struct MergeView {
    SurfacePoints seen;      ///< by paths from the camera, at random over the image
    size_t cameraPaths = 0;  ///< how many paths looked for them
    SurfacePoints lit;       ///< vertices of light paths
    size_t lightPaths = 0;   ///< how many paths left them
};

/// The area of a surface on which these points lie at random: their number times what each has for itself, by the median distance to the
/// nearest other one, which for n of them in a unit of area is sqrt(ln 2 / (pi n)). Those that coincide count once. Takes the square of
/// their number of steps. Nothing for fewer than 16 points.
std::optional<double> surfaceOf(std::vector<vec3> points);

/// The radius of the first pass of an image of so many pixels and light paths: of three pixels as the camera sees them, since light that is
/// smeared over more shows; but where no light vertex lies within, in the median, as wide as one takes. Never wider than
/// `most`. Measured (docs/hard-light.md). Nothing if the camera sees too little. Scene units.
std::optional<double> chooseMergeRadius(const MergeView& view, double pixels, double lightPaths, double most);

}  // namespace eikonal
