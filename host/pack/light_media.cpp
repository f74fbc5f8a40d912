#include "pack/light_media.h"

#include "kinds/material_kind.h"
#include "kinds/shape_kind.h"
#include "pack/scene_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace eikonal {
namespace {

struct Segment {
    glm::dvec3 from, step;   ///< points from + t step, t in (0, 1)
};
/// Where a segment meets a boundary first, and whether it comes from the outside.
struct Crossing { double t = 1; bool fromOutside = true; };

bool mayMeet(const Segment& s, const Box& box) {
    double first = 0, last = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (s.step[axis] == 0) {
            if (s.from[axis] < box.low[axis] || s.from[axis] > box.high[axis]) return false;
            continue;
        }
        const double a = (box.low[axis] - s.from[axis]) / s.step[axis], b = (box.high[axis] - s.from[axis]) / s.step[axis];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return first <= last;
}

bool isSphere(const Shape& s) { return s.kind == &kindOf(shape_sphere); }
bool isWhole(const Shape& s) { return s.zMin <= -s.radius && s.zMax >= s.radius && s.phiMax >= 360; }
bool isMesh(const Shape& s) { return s.mesh && (s.kind == &kindOf(shape_triangle) || s.kind == &kindOf(shape_bilinear)); }
bool isTold(const Shape& s) { return !s.worldFromObjectAtEnd && ((isSphere(s) && isWhole(s)) || isMesh(s)); }

void crossSphere(const Shape& s, const Segment& segment, Crossing& nearest) {
    const glm::dmat4 m = glm::inverse(s.worldFromObject);
    const glm::dvec3 o = transformPoint(m, segment.from), d(m * glm::dvec4(segment.step, 0));
    const double a = glm::dot(d, d), b = glm::dot(o, d) / a, c = (glm::dot(o, o) - s.radius * s.radius) / a, root = b * b - c;
    if (!(root >= 0)) return;
    const bool outwards = s.reverseOrientation == swapsHandedness(s.worldFromObject);
    for (const double t : {-b - std::sqrt(root), -b + std::sqrt(root)})
        if (t > 0 && t < nearest.t) nearest = {t, (c > 0) == outwards};
}

void crossTriangle(const Shape& s, const glm::dmat4& placed, std::array<std::uint32_t, 3> corners, const Segment& segment,
                   Crossing& nearest) {
    const Mesh& mesh = *s.mesh;
    std::array<glm::dvec3, 3> p;
    for (size_t i = 0; i < 3; ++i) p[i] = transformPoint(placed, mesh.positions[corners[i]]);
    const glm::dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0], n = glm::cross(e1, e2), away = segment.from - p[0];
    const double along = glm::dot(n, segment.step);
    if (along == 0) return;
    const glm::dvec3 q = glm::cross(segment.step, away);
    const double t = -glm::dot(n, away) / along, u = glm::dot(e2, q) / along, v = -glm::dot(e1, q) / along;
    if (!(t > 0 && t < nearest.t && u >= 0 && v >= 0 && u + v <= 1)) return;
    /* The side of vertex normals, if there are any (kernels/shape/triangle.clh) */
    bool flips = s.reverseOrientation != swapsHandedness(s.worldFromObject);
    if (!mesh.normals.empty()) {
        const glm::dvec3 mean = (1 - u - v) * glm::dvec3(mesh.normals[corners[0]]) + u * glm::dvec3(mesh.normals[corners[1]]) +
                                v * glm::dvec3(mesh.normals[corners[2]]);
        const double side = glm::dot(n, transformNormal(s.worldFromObject, mean));
        if (side != 0) flips = (side < 0) != s.reverseOrientation;
    }
    nearest = {t, (along < 0) != flips};
}

void crossMesh(const Shape& s, const Segment& segment, Crossing& nearest) {
    const glm::dmat4 placed = fromPositions(s.worldFromObject, s.mesh->origin);
    const std::vector<std::uint32_t>& at = s.mesh->indices;
    const bool patches = s.kind == &kindOf(shape_bilinear);
    for (size_t i = 0; i + (patches ? 3 : 2) < at.size(); i += patches ? 4 : 3) {
        crossTriangle(s, placed, {at[i], at[i + 1], at[i + 2]}, segment, nearest);
        /* The other half of a patch; its corners are (0,0) (1,0) (0,1) (1,1) */
        if (patches) crossTriangle(s, placed, {at[i + 3], at[i + 2], at[i + 1]}, segment, nearest);
    }
}

void cross(const Shape& s, const Segment& segment, Crossing& nearest) {
    if (isSphere(s)) crossSphere(s, segment, nearest);
    else crossMesh(s, segment, nearest);
}

/// Some points of a boundary: the middle of some faces, or where a sphere is nearest to the eye.
std::vector<glm::dvec3> pointsOf(const Shape& s, glm::dvec3 eye) {
    if (isSphere(s)) {
        const glm::dvec3 to = transformPoint(glm::inverse(s.worldFromObject), eye);
        const double distance = glm::length(to);
        if (distance == 0) return {};
        return {transformPoint(s.worldFromObject, to * (s.radius / distance))};
    }
    constexpr size_t most = 8;
    const size_t corners = s.kind == &kindOf(shape_bilinear) ? 4 : 3, faces = s.mesh->indices.size() / corners;
    const size_t step = std::max(faces / most, size_t{1});
    const glm::dmat4 placed = fromPositions(s.worldFromObject, s.mesh->origin);
    std::vector<glm::dvec3> points;
    for (size_t f = 0; f < faces && points.size() < most; f += step) {
        glm::dvec3 sum(0);
        for (size_t c = 0; c < 3; ++c) sum += transformPoint(placed, s.mesh->positions[s.mesh->indices[f * corners + c]]);
        points.push_back(sum / 3.);
    }
    return points;
}

/// For each material, whether it is that of a subsurface body, or a mix with one. Mixes may share their parts, so each is looked at once.
std::vector<bool> materialsOfBodies(const Scene& scene) {
    std::vector<std::optional<bool>> known(scene.materials.size());
    const auto isOfBody = [&](int index, auto& self) -> bool {
        if (index == none) return false;
        const Material& m = scene.materials[static_cast<size_t>(index)];
        std::optional<bool>& is = known[static_cast<size_t>(index)];
        if (!is) is = m.interior || m.diffusion || std::ranges::any_of(m.mixed, [&](int part) { return self(part, self); });
        return *is;
    };
    std::vector<bool> are;
    for (size_t i = 0; i < known.size(); ++i) are.push_back(isOfBody(static_cast<int>(i), isOfBody));
    return are;
}

}  // namespace

LightMedia::LightMedia(const Scene& scene)
    : ofBody_(materialsOfBodies(scene)),
      eye_(transformPoint(scene.camera.worldFromCamera, glm::dvec3(0))),
      aroundCamera_(scene.camera.medium),
      scene_(scene) {
    for (const Shape& s : scene.shapes)
        if (s.interface && isTold(s)) {
            boundaries_.push_back(&s);
            boxes_.push_back(s.kind->traits.bound(s, s.worldFromObject));
        }
    for (const Shape& s : scene.shapes)
        if (isBody(s) && isTold(s)) {
            bodies_.push_back(&s);
            bodyBoxes_.push_back(s.kind->traits.bound(s, s.worldFromObject));
        }
    untoldBodies_ = boxesOf(scene, [&](const Shape& s) { return isBody(s) && std::ranges::find(bodies_, &s) == bodies_.end(); });
    /* Shapes of objects are none of boundaries_ */
    untold_ = boxesOf(scene, [&](const Shape& s) { return s.interface && std::ranges::find(boundaries_, &s) == boundaries_.end(); });
}

static size_t elementsOf(const Shape& s) { return isMesh(s) ? s.mesh->indices.size() / 3 : 1; }

std::optional<int> LightMedia::at(glm::dvec3 p, const Shape* except) const {
    const std::optional<Told> told = tell(p, except);
    return told ? std::optional(told->medium) : std::nullopt;
}

std::optional<LightMedia::Told> LightMedia::tell(glm::dvec3 p, const Shape* except) const {
    const Segment segment{p, eye_ - p};
    if (testsLeft_ <= 0 || std::ranges::any_of(untold_, [&](const Box& box) { return mayMeet(segment, box); })) return {};
    Crossing nearest;
    const Shape* met = nullptr;
    for (size_t i = 0; i < boundaries_.size(); ++i) {
        if (boundaries_[i] == except || !mayMeet(segment, boxes_[i])) continue;
        const double before = nearest.t;
        cross(*boundaries_[i], segment, nearest);
        testsLeft_ -= static_cast<double>(elementsOf(*boundaries_[i]));
        if (nearest.t < before) met = boundaries_[i];
    }
    if (!met) return Told{aroundCamera_, nullptr};
    return Told{nearest.fromOutside ? met->interface->outside : met->interface->inside, met};
}

std::optional<int> LightMedia::outside() const {
    Box all;
    all.grow(eye_);
    for (const Box& box : boxes_) all.grow(box);
    for (const Box& box : untold_) all.grow(box);
    return at(all.center() + glm::dvec3(.36, .48, .8) * (4 * all.radius() + 1));
}

bool LightMedia::isBody(const Shape& s) const {
    return !scene_.forcesDiffuse && s.material != none && ofBody_[static_cast<size_t>(s.material)];
}

bool LightMedia::mayBeInBody(glm::dvec3 p) const {
    const auto holds = [p](const Box& box) {
        return glm::all(glm::lessThanEqual(box.low, p)) && glm::all(glm::lessThanEqual(p, box.high));
    };
    if (std::ranges::any_of(untoldBodies_, holds)) return true;
    for (size_t i = 0; i < bodies_.size(); ++i) {
        if (!holds(bodyBoxes_[i])) continue;
        Crossing nearest;
        cross(*bodies_[i], {p, eye_ - p}, nearest);
        testsLeft_ -= static_cast<double>(elementsOf(*bodies_[i]));
        if (testsLeft_ <= 0 || (nearest.t < 1 && !nearest.fromOutside)) return true;
    }
    return false;
}

bool LightMedia::isSeeThrough(const Shape& s) const {
    if (s.material == none) return false;
    const MaterialKind* kind = scene_.materials[static_cast<size_t>(s.material)].kind;
    return kind == &interface_material || kind == &dielectric_material || kind == &thin_dielectric_material;
}

std::optional<LightMedia::Contradiction> LightMedia::contradictionAt(const Shape& s, glm::dvec3 p) const {
    const glm::dvec3 before = p + 1e-5 * (eye_ - p);
    const std::optional<Told> found = tell(before, nullptr);
    /* What is behind an opaque boundary is not seen, and may be part of what it bounds */
    if (!found || (found->by && !isSeeThrough(*found->by))) return {};
    Crossing there;
    cross(s, {before, 2. * (p - before)}, there);
    testsLeft_ -= static_cast<double>(elementsOf(s));
    if (there.t == 1) return {};
    const int said = there.fromOutside ? s.interface->outside : s.interface->inside;
    if (said == found->medium) return {};
    return Contradiction{&s, said, found->medium};
}

std::optional<LightMedia::Contradiction> LightMedia::contradiction() const {
    for (const Shape* s : boundaries_)
        for (const glm::dvec3& p : pointsOf(*s, eye_))
            if (const std::optional<Contradiction> c = contradictionAt(*s, p)) return c;
    return {};
}

}  // namespace eikonal
