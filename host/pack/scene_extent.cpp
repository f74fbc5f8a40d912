#include "pack/scene_extent.h"

#include "kinds/shape_kind.h"

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

/// Adds a shape with this box that is there `count` times.
void add(SceneExtents& extents, const Shape& shape, const Box& box, double count, glm::dvec3 eye) {
    const Extent extent = extentOf(box, eye) * count;
    extents.materials[shape.material] += extent;
    if (shape.areaLight != none) extents.areaLights[shape.areaLight] += extent;
    if (shape.interface && shape.interface->inside != none) extents.media[shape.interface->inside] += extent;
}

}  // namespace

Extent Extent::operator*(double count) const { return {area * count, sight * count, chord}; }

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

SceneExtents extentsOf(const Scene& scene, const Box& near) {
    SceneExtents extents;
    const glm::dvec3 eye = transformPoint(scene.camera.worldFromCamera, glm::dvec3(0));
    const auto boundOf = [](const Shape& s) { return s.kind->traits.bound(s, s.worldFromObject); };
    for (const Shape& s : scene.shapes) add(extents, s, boundOf(s), 1, eye);

    std::vector<std::vector<size_t>> places(scene.objects.size());
    for (size_t i = 0; i < scene.instances.size(); ++i) places[static_cast<size_t>(scene.instances[i].object)].push_back(i);
    constexpr size_t mostPlaced = 1'000'000;
    for (size_t o = 0; o < places.size(); ++o) {
        const Object& object = scene.objects[o];
        const size_t step = 1 + places[o].size() * object.shapes.size() / mostPlaced;
        for (const Shape& s : object.shapes) {
            const Box box = boundOf(s);
            for (size_t first = 0; first < places[o].size(); first += step) {
                const auto count = static_cast<double>(std::min(step, places[o].size() - first));
                add(extents, s, transformed(box, scene.instances[places[o][first]].worldFromObject), count, eye);
            }
        }
    }

    /* Media around the camera or outside of shapes fill the scene */
    if (scene.camera.medium != none) extents.media[scene.camera.medium] += {areaOf(near), 1, chordOf(near)};
    extents.radius = near.empty() ? 1 : std::max(near.radius(), 1e-300);
    return extents;
}

}  // namespace eikonal
