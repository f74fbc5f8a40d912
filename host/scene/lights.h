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

/// Intensity and radiance: spectrum * scale.
struct PointLight { Spectrum I; glm::dvec3 from{0}; };
struct SpotLight { Spectrum I; glm::dvec3 from{0}, to{0, 0, 1}; double coneAngle = 30, coneDeltaAngle = 5; };
/// A point whose intensity is I times an image over the sphere of directions (square, equal-area), whose +z is +y of light space.
struct GoniometricLight { Spectrum I; int image = none; };
/// A slide in front of a point, projected along +z of light space, its top at +y; fov: degrees that its shorter side spans.
struct ProjectionLight { int image = none; double fov = 90; };
struct DistantLight { Spectrum L; glm::dvec3 from{0}, to{0, 0, 1}; };
struct ConstantInfiniteLight { Spectrum L; };
/// An image over the sphere of directions, square, in the equal-area octahedral mapping of Clarberg 2008.
struct ImageInfiniteLight { int image = none; };
/// An infinite light as far as it comes in through a rectangle: world space, not moved by worldFromLight. From corner 0, x runs to
/// corner 3 and y to corner 1; x cross y points out of the room. L everywhere, or an image as above.
struct PortalInfiniteLight { Spectrum L; int image = none; std::array<glm::dvec3, 4> portal; };

struct Light {
    std::variant<PointLight, SpotLight, GoniometricLight, ProjectionLight, DistantLight, ConstantInfiniteLight, ImageInfiniteLight, PortalInfiniteLight> kind;
    double scale = 1;
    std::optional<double> power;          ///< goniometric, projection: what is emitted in all, where the image is taken as it is
    std::optional<double> illuminance;    ///< infinite with an image: lux on a surface that faces the image's +z
    Transform worldFromLight{1};
    SourceLocation where;
};

/// What makes a shape emit.
struct AreaLight {
    Spectrum L;
    int image = none;                     ///< in Scene::images: L is multiplied by it
    Mapping imageMapping;                 ///< of the image: from the shape's (u, v)
    double scale = 1;
    std::optional<double> power;
    bool twoSided = false;
    SourceLocation where;
};

}  // namespace eikonal
