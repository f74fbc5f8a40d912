#include "pack/scene_bounds.h"

#include "kinds/shape_kind.h"
#include "pack/motion.h"
#include "pack/scene_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace eikonal {
namespace {

/// Bounds of a static or moving box.
Box reachOf(const Box& box, const glm::dmat4& start, const std::optional<glm::dmat4>& end, TimeSpan seen) {
    return end ? boundsInMotion({Motion(start, *end)}, box, seen) : transformed(box, start);
}
Box reachOf(const Shape& s, TimeSpan seen) {
    const auto bound = s.kind->traits.bound;
    if (!s.worldFromObjectAtEnd) return bound(s, s.worldFromObject);
    return reachOf(bound(s, glm::dmat4(1)), s.worldFromObject, s.worldFromObjectAtEnd, seen);
}

/// The largest distance of a point of the box.
double reachFrom(glm::dvec3 eye, const Box& box) { return glm::length(glm::max(glm::abs(box.low - eye), glm::abs(box.high - eye))); }

/// The mean over shapes, weighted by sight, of the square of (distance of the shape from an origin) / (size of the shape): how much
/// rounding blurs the image.
class RoundingCost {
public:
    RoundingCost(std::span<const PlacedBox> boxes, glm::dvec3 eye) : eye_(eye) {
        for (const PlacedBox& b : boxes) {
            const double size = b.box.radius();
            if (!(size > 0) || !(b.sight > 0)) continue;
            const glm::dvec3 center = b.box.center() - eye;
            const double weight = b.sight / (size * size);
            sight_ += b.sight;
            weight_ += weight;
            first_ += weight * center;
            second_ += weight * glm::dot(center, center);
        }
    }
    double operator()(glm::dvec3 origin) const {
        const glm::dvec3 o = origin - eye_;
        const double sum = weight_ * glm::dot(o, o) - 2 * glm::dot(first_, o) + second_;
        return sight_ > 0 ? std::max(sum, 0.0) / sight_ : 0;
    }

private:
    glm::dvec3 eye_, first_{0};
    double sight_ = 0, weight_ = 0, second_ = 0;
};

}  // namespace

Box nearBox(std::span<const PlacedBox> boxes, glm::dvec3 eye) {
    Box all;
    for (const PlacedBox& b : boxes) all.grow(b.box);
    if (all.empty() || !std::isfinite(all.radius())) return all;
    const RoundingCost costAt(boxes, eye);
    /* Rounding by 2^-24 of this many sizes is not seen */
    constexpr double bearable = 32, few = 4;
    if (costAt(all.center()) <= bearable * bearable) return all;

    /* Nested boxes: add one after the other, from the nearest to the farthest */
    std::vector<std::pair<double, size_t>> order;
    order.reserve(boxes.size());
    for (size_t i = 0; i < boxes.size(); ++i) order.emplace_back(reachFrom(eye, boxes[i].box), i);
    std::ranges::sort(order);
    std::vector<double> costs;
    costs.reserve(boxes.size());
    double least = costAt(all.center());
    Box box;
    for (const auto& [reach, i] : order) {
        box.grow(boxes[i].box);
        costs.push_back(box.empty() ? std::numeric_limits<double>::infinity() : costAt(box.center()));
        least = std::min(least, costs.back());
    }
    const double most = std::max(bearable * bearable, few * few * least);
    const auto isBearable = [most](double cost) { return cost <= most; };
    const auto last = std::find_if(costs.rbegin(), costs.rend(), isBearable);
    box = {};
    for (const auto& [reach, i] : std::span(order).first(static_cast<size_t>(costs.rend() - last))) box.grow(boxes[i].box);
    return box;
}

SceneBounds boundsOf(const Scene& scene) {
    const TimeSpan seen = timesSeen(scene);
    const glm::dvec3 eye = transformPoint(scene.camera.worldFromCamera, glm::dvec3(0));
    std::vector<PlacedBox> boxes;
    const auto add = [&](const Box& box) {
        if (!box.empty()) boxes.push_back({box, sightOf(box, eye)});
    };
    for (const Shape& s : scene.shapes) add(reachOf(s, seen));
    std::vector<Box> objects;
    for (const Object& o : scene.objects) {
        Box b;
        for (const Shape& s : o.shapes) b.grow(reachOf(s, seen));
        objects.push_back(b);
    }
    for (const Instance& i : scene.instances)
        add(reachOf(objects[static_cast<size_t>(i.object)], i.worldFromObject, i.worldFromObjectAtEnd, seen));
    SceneBounds bounds;
    for (const PlacedBox& b : boxes) bounds.all.grow(b.box);
    bounds.near = nearBox(boxes, eye);
    return bounds;
}

std::vector<Box> boxesOf(const Scene& scene, const std::function<bool(const Shape&)>& counts) {
    const TimeSpan seen = timesSeen(scene);
    std::vector<Box> boxes;
    for (const Shape& s : scene.shapes)
        if (counts(s)) boxes.push_back(reachOf(s, seen));
    std::vector<std::vector<Box>> objects(scene.objects.size());
    for (size_t o = 0; o < objects.size(); ++o)
        for (const Shape& s : scene.objects[o].shapes)
            if (counts(s)) objects[o].push_back(reachOf(s, seen));
    for (const Instance& i : scene.instances)
        for (const Box& box : objects[static_cast<size_t>(i.object)])
            boxes.push_back(reachOf(box, i.worldFromObject, i.worldFromObjectAtEnd, seen));
    return boxes;
}

SceneSpace spaceOf(const SceneBounds& bounds) {
    SceneSpace space = spaceOf(bounds.near);
    if (bounds.all.empty()) return space;
    /* Products of four coordinates must not overflow */
    const double largest = reachFrom(space.center, bounds.all) * space.scale;
    if (largest > 0x1p40 && std::isfinite(largest)) space.scale = std::ldexp(space.scale, 40 - std::ilogb(largest) - 1);
    return space;
}

}  // namespace eikonal
