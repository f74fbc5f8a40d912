#pragma once
// The graphics state, which AttributeBegin saves and AttributeEnd restores.

#include "read/pbrt/parameters.h"
#include "color/observer.h"
#include "scene/basics.h"

#include <array>
#include <cmath>
#include <memory>

namespace eikonal::pbrt {

/// The targets of Attribute directives, in the order of attributeTargets.
enum class Target { shape, light, material, medium, texture };
constexpr const char* attributeTargets[] = {"shape", "light", "material", "medium", "texture"};
constexpr int targetCount = 5;

/// Transforms to world space at the start and the end of motion.
using Motion = std::array<Transform, 2>;

/// Whether both transforms are invertible; false for a Scale of 0.
inline bool isInvertible(const Motion& motion) {
    return std::abs(glm::determinant(motion[0])) > 0 && std::abs(glm::determinant(motion[1])) > 0;
}

struct GraphicsState {
    Motion transform{Transform(1), Transform(1)};
    std::array<bool, 2> active{true, true};    ///< which of the two the transform directives change
    bool reverseOrientation = false;
    ColorSpace space = ColorSpace::srgb;
    int material = none;                       ///< number in MaterialRegistry
    int areaLight = none;                      ///< in Scene::areaLights
    int inside = none, outside = none;         ///< numbers in MediumRegistry
    std::array<std::shared_ptr<const ParameterList>, targetCount> attributes;  ///< null: none

    bool moves() const { return transform[0] != transform[1]; }
    std::shared_ptr<const ParameterList> attributesOf(Target target) const { return attributes[static_cast<int>(target)]; }
};

}  // namespace eikonal::pbrt
