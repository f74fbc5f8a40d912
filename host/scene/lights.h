#pragma once
// Lights of a scene.

#include "color/spectrum.h"
#include "error.h"
#include "scene/basics.h"
#include "scene/textures.h"

#include <array>
#include <optional>
#include <string>

namespace eikonal {

struct LightKind;   // host/kinds/light_kind.h

/// A light without a shape. Which fields count depends on its kind (host/kinds/light/); the others keep their defaults.
struct Light {
    const LightKind* kind = nullptr;
    Spectrum spectrum = Spectrum::rgb({1, 1, 1}, ColorSpace::srgb);   ///< intensity, irradiance or radiance: spectrum * scale
    int image = none;                     ///< in Scene::images
    glm::dvec3 from{0}, to{0, 0, 1};      ///< light space; from: its position; distant: light travels from `from` to `to`
    double coneAngle = 30, coneDeltaAngle = 5;   ///< spot, degrees: edge of the cone, and width of the falloff inside it
    double fov = 90;                      ///< projection, degrees: along the shorter side of the image
    /// Corners of a rectangle in world space, not moved by worldFromLight. From corner 0, x runs to corner 3 and y to corner 1;
    /// x cross y points out of the room.
    std::array<glm::dvec3, 4> portal{};
    double scale = 1;
    std::optional<double> power;          ///< goniometric, projection: total power, for the image as it is
    std::optional<double> illuminance;    ///< infinite with an image: illuminance (lux) of a surface that faces the image's +z
    Transform worldFromLight{1};
    std::string group;                    ///< its light group; empty: that of lights that name none
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
    std::string group;                    ///< as in Light
    SourceLocation where;
};

}  // namespace eikonal
