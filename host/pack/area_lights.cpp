// Lights with a shape: one for each element of a shape that emits.

#include "kinds/shape_kind.h"
#include "pack/lights.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace eikonal {

/// Emitted power in scene units, for the light sampler.
static double areaPower(const light& l, double luminance) {
    return l.pmf > 0 ? M_PI * luminance / l.inverse_area * (l.two_sided ? 2 : 1) : 0;
}

/// light::rounding. A coordinate of a sampled point is a sum of up to four floats times numbers in [-1, 1] (kernels/light/): some five
/// roundings of the point and of the light's extent. They seldom add up; with one of each, nothing of a light is lost in a wall that it
/// lies on (tests/kernels/light_shadow_test.cpp).
static float roundingOf(const light& l) {
    const LightBounds bounds = boundsOfLight(l, 0);
    const glm::dvec3 farthest = glm::max(glm::abs(bounds.box.low), glm::abs(bounds.box.high)), extent = bounds.box.high - bounds.box.low;
    const glm::dvec3 error = std::ldexp(1, -24) * (farthest + extent);
    return static_cast<float>(bounds.normals > 0 ? glm::length(error) : glm::dot(error, glm::abs(bounds.axis)));
}

void LightPacker::addShape(const Shape& s, shape& packed, const GeometryTables& geometry, const glm::dmat4& m, size_t elements) {
    const AreaLight& description = context_.scene.areaLights[static_cast<size_t>(s.areaLight)];
    packed.first_light = static_cast<uint>(tables_.lights.size());
    const bool isUnseen = s.alpha.texture == none && s.alpha.value.value() <= 0;
    if (isUnseen) packed.flags |= shape_is_unseen;
    if (description.twoSided) packed.flags |= shape_is_two_sided;
    if (description.image != none) packed.emission = textures_.emissionImage(description);
    const bool hasPattern = packed.emission != NONE || (packed.alpha != NONE && !isUnseen);
    const double scale = description.scale * (description.image != none ? textures_.meanLuminance(description.image) : 1);
    const color L = colors_.emission(description.L, scale);
    if (!s.kind->traits.lightKindOf) throw std::logic_error(std::string("no area light for shape ") + s.kind->name);
    const uint group = groupNumber(description.group);
    const LightKind& kind = kindOf(s.kind->traits.lightKindOf(s, m));
    if (kind.traits.isAimedByDirection) packed.flags |= shape_is_aimed_by_direction;
    bool anyTurns = false, hasArea = false;
    for (size_t e = 0; e < elements; ++e) {
        light l = kind.traits.packElement({geometry, s, packed, e, m}, L);
        /* Where vertex normals choose the side, light samples do not know it, and the pattern does */
        const bool turns = l.two_sided && !description.twoSided;
        anyTurns = anyTurns || turns;
        if (description.twoSided) l.two_sided = 1;
        /* With an alpha of 0 it emits but is invisible (as in pbrt-v4) */
        l.invisible = isUnseen;
        l.group = group;
        l.element = packed.first_element + static_cast<uint>(e);
        l.has_pattern = hasPattern || turns;
        l.rounding = roundingOf(l);
        /* As in pbrt-v4, "power" is that of each element, ignoring alpha */
        double factor = scale;
        if (description.power && l.inverse_area > 0) {
            const double area = 1 / (l.inverse_area * context_.space.scale * context_.space.scale);
            factor = description.scale * *description.power / (M_PI * area * (description.twoSided ? 2 : 1));
            l.L = colors_.emission(description.L, factor);
        }
        hasArea = hasArea || l.inverse_area > 0;
        colors_.checkRange(l.L, description.where, "\"L\" of an area light");
        powers_.push_back(areaPower(l, luminanceOf(description.L, factor)));
        emitted_.push_back({kind.traits.startsPaths ? powers_.back() : 0, &s});
        tables_.lights.push_back(l);
    }
    if (!hasArea)
        context_.diagnostics.warn(s.where, "this shape has no area, so as a lamp it sends no light");
    const std::string why = description.where.toString() + ": area light";
    context_.require(Feature::EMITTERS, why);
    if (hasPattern || anyTurns) context_.require(Feature::LIGHT_PATTERN, why);
    context_.require(kind.feature, why);
}

}  // namespace eikonal
