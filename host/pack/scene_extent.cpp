#include "pack/scene_extent.h"

#include "kinds/shape_kind.h"
#include "pack/scene_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eikonal {
namespace {

/// Half the surface of a box: the surface of a flat thing, and about that of a sphere.
double areaOf(const Box& box) {
    const glm::dvec3 d = box.high - box.low;
    return d.x * d.y + d.y * d.z + d.z * d.x;
}

/// Four times the volume over the surface; of something flat, 0.
double chordOf(const Box& box) {
    const glm::dvec3 d = box.high - box.low;
    const double area = areaOf(box);
    return area > 0 ? 2 * d.x * d.y * d.z / area : 0;
}

Extent extentOf(const Box& box, glm::dvec3 eye) {
    if (box.empty()) return {};
    return {areaOf(box), sightOf(box, eye), chordOf(box)};
}

class Collector {
public:
    Collector(SceneExtents& extents, glm::dvec3 eye) : extents_(extents), eye_(eye) {}

    void add(const Shape& shape, const Box& box) {
        const Extent extent = extentOf(box, eye_);
        extents_.materials[shape.material] += extent;
        if (shape.areaLight != none) extents_.areaLights[shape.areaLight] += extent;
        if (shape.interface && shape.interface->inside != none) extents_.media[shape.interface->inside] += extent;
        if (!box.empty()) boxes_.push_back({box, extent.sight});
    }
    /// Media around the camera or outside of shapes fill the scene.
    void finish(int surroundings) {
        const Box whole = nearBox(boxes_, eye_);
        if (surroundings != none) extents_.media[surroundings] += {areaOf(whole), 1, chordOf(whole)};
        extents_.radius = whole.empty() ? 1 : std::max(whole.radius(), 1e-300);
    }

private:
    SceneExtents& extents_;
    glm::dvec3 eye_;
    std::vector<PlacedBox> boxes_;
};

}  // namespace

Extent& Extent::operator+=(const Extent& b) {
    area += b.area;
    sight += b.sight;
    chord = std::max(chord, b.chord);
    return *this;
}

double sightOf(const Box& box, glm::dvec3 eye) {
    const double distance = glm::length(box.center() - eye), seen = areaOf(box) / 2;
    const bool surrounds = glm::all(glm::lessThanEqual(box.low, eye)) && glm::all(glm::greaterThanEqual(box.high, eye));
    return surrounds ? 1 : std::min(seen / (4 * std::numbers::pi * std::max(distance * distance, 1e-300)), 1.0);
}

SceneExtents extentsOf(const Scene& scene) {
    SceneExtents extents;
    Collector all(extents, transformPoint(scene.camera.worldFromCamera, glm::dvec3(0)));
    const auto boundOf = [](const Shape& s) { return s.kind->traits.bound(s, s.worldFromObject); };
    for (const Shape& s : scene.shapes) all.add(s, boundOf(s));
    std::vector<std::vector<Box>> boxes;
    for (const Object& o : scene.objects) {
        boxes.emplace_back();
        for (const Shape& s : o.shapes) boxes.back().push_back(boundOf(s));
    }
    for (const Instance& i : scene.instances) {
        const Object& object = scene.objects[static_cast<size_t>(i.object)];
        for (size_t s = 0; s < object.shapes.size(); ++s)
            all.add(object.shapes[s], transformed(boxes[static_cast<size_t>(i.object)][s], i.worldFromObject));
    }
    all.finish(scene.camera.medium);
    return extents;
}

}  // namespace eikonal
