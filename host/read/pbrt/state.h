#pragma once
// What holds at a point of the file, and is saved and restored by AttributeBegin and AttributeEnd.

#include "read/pbrt/parameters.h"
#include "scene/scene.h"

#include <array>
#include <cmath>
#include <memory>

namespace eikonal::pbrt {

/// What an Attribute directive can set parameters for. In the order of attributeTargets.
enum class Target { shape, light, material, medium, texture };
constexpr const char* attributeTargets[] = {"shape", "light", "material", "medium", "texture"};
constexpr int targetCount = 5;

/// Transforms to world space where the shutter opens and where it closes.
using Motion = std::array<Transform, 2>;

/// Whether both lead back: false for a Scale of 0.
inline bool isInvertible(const Motion& motion) {
    return std::abs(glm::determinant(motion[0])) > 0 && std::abs(glm::determinant(motion[1])) > 0;
}

struct GraphicsState {
    Motion transform{Transform(1), Transform(1)};
    std::array<bool, 2> active{true, true};    ///< which of them transform directives change
    bool reverseOrientation = false;
    ColorSpace space = ColorSpace::srgb;
    int material = none;                       ///< in MaterialRegistry
    int areaLight = none;                      ///< in Scene::areaLights
    int inside = none, outside = none;         ///< in MediumRegistry
    std::array<std::shared_ptr<const ParameterList>, targetCount> attributes;  ///< null: none

    bool moves() const { return transform[0] != transform[1]; }
    std::shared_ptr<const ParameterList> attributesOf(Target target) const { return attributes[static_cast<int>(target)]; }
};

}  // namespace eikonal::pbrt
