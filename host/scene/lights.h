#pragma once
// Lights of a scene.

#include "error.h"
#include "scene/basics.h"
#include "scene/textures.h"
#include "color/spectrum.h"

#include <array>
#include <optional>
#include <variant>

namespace eikonal {

/// Intensities and radiances are spectrum * scale.
struct PointLight { Spectrum I; glm::dvec3 from{0}; };
struct SpotLight { Spectrum I; glm::dvec3 from{0}, to{0, 0, 1}; double coneAngle = 30, coneDeltaAngle = 5; };
/// A point whose intensity is I times an image over the sphere of directions (square, equal-area mapping), whose +z is +y of light space.
struct GoniometricLight { Spectrum I; int image = none; };
/// A projector at a point: the image is projected along +z of light space, its top at +y. fov: degrees spanned by the shorter side.
struct ProjectionLight { int image = none; double fov = 90; };
struct DistantLight { Spectrum L; glm::dvec3 from{0}, to{0, 0, 1}; };
struct ConstantInfiniteLight { Spectrum L; };
/// An image over the sphere of directions; square, in the equal-area octahedral mapping of Clarberg 2008.
struct ImageInfiniteLight { int image = none; };
/// An infinite light that is visible only through a rectangle, given in world space and not moved by worldFromLight. From corner 0, x runs
/// to corner 3 and y to corner 1; x cross y points out of the room. Constant radiance L, or an image as above.
struct PortalInfiniteLight { Spectrum L; int image = none; std::array<glm::dvec3, 4> portal; };

struct Light {
    std::variant<PointLight, SpotLight, GoniometricLight, ProjectionLight, DistantLight, ConstantInfiniteLight, ImageInfiniteLight, PortalInfiniteLight> kind;
    double scale = 1;
    std::optional<double> power;          ///< goniometric, projection: total power, for the image as it is
    std::optional<double> illuminance;    ///< infinite with an image: illuminance (lux) of a surface that faces the image's +z
    Transform worldFromLight{1};
    SourceLocation where;
};

/// Emission of a shape.
struct AreaLight {
    Spectrum L;
    int image = none;                     ///< in Scene::images: multiplies L
    Mapping imageMapping;                 ///< maps the shape's (u, v) to the image
    double scale = 1;
    std::optional<double> power;
    bool twoSided = false;
    SourceLocation where;
};

}  // namespace eikonal
