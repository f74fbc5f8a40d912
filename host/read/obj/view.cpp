#include "read/obj/view.h"

#include "read/obj/turntable.h"
#include "read/obj/visibility.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace eikonal {
namespace {

/// The axes that define "right", "front" and "above".
struct Compass {
    glm::dvec3 right, front, up;
    explicit Compass(glm::dvec3 upwards) : up(glm::normalize(upwards)) {
        const glm::dvec3 z(0, 0, 1), y(0, 1, 0), towards = std::abs(glm::dot(up, z)) < 0.9 ? z : -y;
        front = glm::normalize(towards - glm::dot(towards, up) * up);
        right = glm::cross(up, front);
    }
    glm::dvec3 direction(glm::dvec3 d) const { return glm::normalize(d.x * right + d.y * up + d.z * front); }
};

struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
    glm::dvec3 middle() const { return (low + high) / 2.; }
    glm::dvec3 size() const { return high - low; }
};

Box boundsOf(const std::vector<ViewedTriangle>& triangles) {
    Box box;
    for (const ViewedTriangle& t : triangles)
        for (const glm::vec3& p : {t.a, t.b, t.c}) {
            box.low = glm::min(box.low, glm::dvec3(p));
            box.high = glm::max(box.high, glm::dvec3(p));
        }
    return triangles.empty() ? Box{glm::dvec3(-1), glm::dvec3(1)} : box;
}

double tangent(double degrees) { return std::tan(degrees / 2 * std::numbers::pi / 180); }

glm::dvec2 halfTangents(const View& view) {
    const double shorter = std::min(view.width, view.height);
    return tangent(view.fov) * glm::dvec2(view.width / shorter, view.height / shorter);
}

/// The smallest distance of the camera from the target at which every vertex is in the image.
double fittingDistance(const std::vector<ViewedTriangle>& triangles, const View& view, double size) {
    const glm::dmat4 frame = worldFromCamera(view);
    const glm::dvec3 right(frame[0]), up(frame[1]), forward(frame[2]);
    const glm::dvec2 t = halfTangents(view);
    double distance = 0.05 * size;
    for (const ViewedTriangle& triangle : triangles)
        for (const glm::vec3& vertex : {triangle.a, triangle.b, triangle.c}) {
            const glm::dvec3 p = glm::dvec3(vertex) - view.target;
            const double nearness = -glm::dot(p, forward);
            distance = std::max({distance, nearness + std::abs(glm::dot(p, right)) * 1.05 / t.x,
                                 nearness + std::abs(glm::dot(p, up)) * 1.05 / t.y, nearness + 0.05 * size});
        }
    return distance;
}

double distanceFor(const std::vector<ViewedTriangle>& triangles, const View& view, double size, const ViewWishes& wishes) {
    return wishes.turns ? turningDistance(triangles, view, halfTangents(view), size) : fittingDistance(triangles, view, size);
}

/// A candidate view.
struct Candidate {
    View view;
    bool isInside = false;
    double preference = 1;
};

std::vector<Candidate> candidates(const std::vector<ViewedTriangle>& triangles, const View& start, const Box& box,
                                  const ViewWishes& wishes) {
    const Compass compass(wishes.up);
    const double size = std::max(glm::length(box.size()), std::numeric_limits<double>::min());
    std::vector<Candidate> result;
    const auto addOutside = [&](glm::dvec3 direction, double preference) {
        Candidate candidate{start, false, preference};
        candidate.view.eye = candidate.view.target + compass.direction(direction);
        candidate.view.eye = candidate.view.target + distanceFor(triangles, candidate.view, size, wishes) * compass.direction(direction);
        result.push_back(candidate);
    };
    addOutside({0.6, 0.45, 1}, 1.1);
    addOutside({-0.6, 0.45, 1}, 1.08);
    addOutside({0, 0, 1}, 1);
    for (const glm::dvec3& direction : {glm::dvec3(0.6, 0.45, -1), {-0.6, 0.45, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 0, -1}})
        addOutside(direction, 0.95);
    if (wishes.turns) return result;
    addOutside({0, 1, 0.001}, 0.9);

    for (const glm::dvec2& corner : {glm::dvec2(1, 1), {-1, 1}, {1, -1}, {-1, -1}}) {
        Candidate candidate{start, true, 0.9};
        const glm::dvec3 extent(glm::dot(glm::abs(compass.right), box.size()), glm::dot(glm::abs(compass.up), box.size()),
                                glm::dot(glm::abs(compass.front), box.size()));
        candidate.view.eye =
            box.middle() + 0.42 * (corner.x * extent.x * compass.right + corner.y * extent.z * compass.front) + 0.2 * extent.y * compass.up;
        if (!wishes.fov) candidate.view.fov = 75;
        result.push_back(candidate);
    }
    return result;
}

/// Chooses a wide image if the model appears wide in this view.
void chooseSize(const std::vector<ViewedTriangle>& triangles, const ViewWishes& wishes, bool isInside, View& view) {
    const glm::dmat4 frame = worldFromCamera(view);
    glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const ViewedTriangle& triangle : triangles)
        for (const glm::vec3& vertex : {triangle.a, triangle.b, triangle.c}) {
            const glm::dvec3 p = glm::dvec3(vertex) - view.eye;
            const glm::dvec2 q(glm::dot(p, glm::dvec3(frame[0])), glm::dot(p, glm::dvec3(frame[1])));
            low = glm::min(low, q);
            high = glm::max(high, q);
        }
    constexpr double wideRatio = 1.35;
    const bool isWide = wishes.turns ? isTurnWider(triangles, view, wideRatio)
                                     : isInside || (!triangles.empty() && high.x - low.x > wideRatio * (high.y - low.y));
    view.width = wishes.width.value_or(wishes.height ? *wishes.height * (isWide ? 16 : 9) / 9 : isWide ? 1280 : 1024);
    view.height = wishes.height.value_or(wishes.width ? *wishes.width * 9 / (isWide ? 16 : 9) : isWide ? 720 : 1024);
}

}  // namespace

std::vector<ViewedTriangle> viewedTriangles(const Scene& scene) {
    std::vector<ViewedTriangle> triangles;
    for (std::uint32_t s = 0; s < scene.shapes.size(); ++s) {
        const Mesh& mesh = *scene.shapes[s].mesh;
        const auto world = [&](std::uint32_t i) { return glm::vec3(scene.shapes[s].worldFromObject * glm::dvec4(mesh.positions[i], 1)); };
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            triangles.push_back({world(mesh.indices[i]), world(mesh.indices[i + 1]), world(mesh.indices[i + 2]), s});
    }
    return triangles;
}

View chooseView(const std::vector<ViewedTriangle>& triangles, const ViewWishes& wishes) {
    const Box box = boundsOf(triangles);
    const double size = std::max(glm::length(box.size()), std::numeric_limits<double>::min());
    View view{.target = wishes.target.value_or(box.middle()), .up = wishes.up, .fov = wishes.fov.value_or(40)};
    if (wishes.eye) {
        view.eye = *wishes.eye;
        chooseSize(triangles, wishes, false, view);
        if (wishes.turns) view.eye = turnedEye(view, *wishes.turns);
        return view;
    }

    std::vector<Candidate> tried = candidates(triangles, view, box, wishes);
    std::vector<double> scores(tried.size());
    tbb::parallel_for(std::size_t(0), tried.size(), [&](std::size_t i) {
        const Candidate& candidate = tried[i];
        scores[i] = candidate.preference * visibleFraction(triangles, candidate.view, candidate.isInside ? 0 : 0.5);
    });
    const Candidate& best = tried[static_cast<std::size_t>(std::ranges::max_element(scores) - scores.begin())];
    view = best.view;
    chooseSize(triangles, wishes, best.isInside, view);
    if (!best.isInside) {
        const glm::dvec3 direction = glm::normalize(view.eye - view.target);
        view.eye = view.target + distanceFor(triangles, view, size, wishes) * direction;
    }
    if (wishes.turns) view.eye = turnedEye(view, *wishes.turns);
    return view;
}

Transform worldFromCamera(const View& view) {
    const glm::dvec3 forward = glm::normalize(view.target - view.eye);
    glm::dvec3 right = glm::cross(forward, view.up);
    if (glm::length(right) < 1e-9 * glm::length(view.up))
        right = glm::cross(forward, std::abs(forward.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1));
    right = glm::normalize(right);
    return {glm::dvec4(right, 0), glm::dvec4(glm::cross(right, forward), 0), glm::dvec4(forward, 0), glm::dvec4(view.eye, 1)};
}

}  // namespace eikonal
