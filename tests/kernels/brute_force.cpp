#include "brute_force.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eikonal {

static glm::dvec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }
static glm::dvec3 mapPoint(const affine& m, glm::dvec3 p) {
    return {m.xx * p.x + m.xy * p.y + m.xz * p.z + m.xw, m.yx * p.x + m.yy * p.y + m.yz * p.z + m.yw, m.zx * p.x + m.zy * p.y + m.zz * p.z + m.zw};
}
static glm::dvec3 mapVector(const affine& m, glm::dvec3 v) {
    return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.yx * v.x + m.yy * v.y + m.yz * v.z, m.zx * v.x + m.zy * v.y + m.zz * v.z};
}

BruteForce::BruteForce(const PackedScene& scene) : scene_(scene), objects_(scene.tables.instances.size()) {
    collect(0, world_, &placed_);
    for (uint i : placed_) collect(scene.tables.instances[i].root, objects_[i], nullptr);
    elements_ = world_.elements.size();
    for (const Group& g : objects_) elements_ += g.elements.size();
}

void BruteForce::collect(uint node, Group& group, std::vector<uint>* instances) {
    const SceneTables& tables = scene_.tables;
    for (uint ref : tables.nodes[node].child) {
        if (ref == NONE) continue;
        if (!(ref & LEAF_BIT)) { collect(ref, group, instances); continue; }
        const uint kind = (ref >> LEAF_KIND_SHIFT) & 7u, count = ((ref >> LEAF_COUNT_SHIFT) & 7u) + 1, first = ref & LEAF_FIRST_MASK;
        if (kind == leaf_triangles) {
            for (uint b = first; b < first + count; ++b)
                for (uint e : tables.triangle_blocks[b].element)
                    if (e != NONE) group.elements.push_back(e);
        } else if (kind == leaf_elements) group.elements.insert(group.elements.end(), &tables.leaf_elements[first], &tables.leaf_elements[first] + count);
        else instances->push_back(first);
    }
}

/// Cramer's rule; margin is the least barycentric coordinate.
static void meetTriangle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 o, glm::dvec3 d, uint element, uint instance, std::vector<Candidate>& found) {
    const glm::dvec3 ab = b - a, ac = c - a, n = glm::cross(ab, ac), ao = o - a;
    const double determinant = -glm::dot(d, n);
    if (determinant == 0 || glm::length(n) == 0) return;
    const glm::dvec3 q = glm::cross(ao, d);
    const double u = glm::dot(ac, q) / determinant, v = -glm::dot(ab, q) / determinant, t = glm::dot(ao, n) / determinant;
    /* Seen edge-on, coordinates and distance are uncertain by the inverse of the cosine */
    const double cosine = std::abs(determinant) / (glm::length(n) * glm::length(d)), size = std::max({glm::length(ab), glm::length(ac), glm::length(b - c)});
    const double reach = std::max({1.0, glm::length(a), glm::length(o)}) / glm::length(d);
    const double blur = 1e-6 * glm::length(d) * reach * size / glm::length(n) / cosine;
    found.push_back({t, element, instance, std::min({u, v, 1 - u - v}) / std::max(1.0, blur / BruteForce::slack), 2e-5 * reach / cosine});
}

static void meetSphere(const quadric& q, glm::dvec3 o, glm::dvec3 d, uint element, uint instance, std::vector<Candidate>& found) {
    const double a = glm::dot(d, d), b = -glm::dot(o, d) / a, r = q.radius;
    const glm::dvec3 nearest = o + b * d;
    const double inside = (r * r - glm::dot(nearest, nearest)) / (r * r);
    if (inside < -1e-3) return;
    const double half = std::sqrt(std::max(inside, 0.0)) * r / std::sqrt(a), blur = 2e-5 * std::max(1.0, glm::length(o)) / std::sqrt(a);
    for (double t : {b - half, b + half}) {
        const glm::dvec3 p = o + t * d;
        double margin = inside < 2e-3 ? 0 : inside;   /* a ray that grazes may hit or miss */
        if (q.z_min > -q.radius) margin = std::min(margin, (p.z - q.z_min) / r);
        if (q.z_max < q.radius) margin = std::min(margin, (q.z_max - p.z) / r);
        if (q.phi_max < static_cast<float>(2 * M_PI)) {
            double phi = std::atan2(p.y, p.x);
            if (phi < 0) phi += 2 * M_PI;
            margin = std::min({margin, phi <= q.phi_max ? std::min(phi, q.phi_max - phi) : -std::min(2 * M_PI - phi, phi - q.phi_max)});
        }
        found.push_back({t, element, instance, margin, blur + (inside < 1e-2 ? 0.1 * r / std::sqrt(a) : 0)});
    }
}

static void meetDisk(const quadric& q, glm::dvec3 o, glm::dvec3 d, uint element, uint instance, std::vector<Candidate>& found) {
    if (d.z == 0) return;
    const double t = (q.z_min - o.z) / d.z;
    const glm::dvec3 p = o + t * d;
    const double r = std::hypot(p.x, p.y), cosine = std::abs(d.z) / glm::length(d);
    double margin = (q.radius - r) / q.radius;
    if (q.inner_radius > 0) margin = std::min(margin, (r - q.inner_radius) / q.radius);
    if (q.phi_max < static_cast<float>(2 * M_PI)) {
        double phi = std::atan2(p.y, p.x);
        if (phi < 0) phi += 2 * M_PI;
        margin = std::min({margin, phi <= q.phi_max ? std::min(phi, q.phi_max - phi) : -std::min(2 * M_PI - phi, phi - q.phi_max)});
    }
    found.push_back({t, element, instance, cosine < 1e-2 ? 0 : margin, 2e-5 * std::max(1.0, glm::length(o)) / glm::length(d) / cosine});
}

/// Roots of a quadratic in u, then v and t on the line of constant u, by least squares.
static void meetPatch(const glm::dvec3 (&p)[4], glm::dvec3 o, glm::dvec3 d, uint element, uint instance, std::vector<Candidate>& found) {
    /* (A + u B) + v (C + u D) - t d = 0 with A = p00 - o: the triple product of both parts with d vanishes */
    const glm::dvec3 A = p[0] - o, B = p[1] - p[0], C = p[2] - p[0], D = p[3] - p[2] - p[1] + p[0];
    const double c0 = glm::dot(glm::cross(A, d), C), c1 = glm::dot(glm::cross(A, d), D) + glm::dot(glm::cross(B, d), C), c2 = glm::dot(glm::cross(B, d), D);
    std::vector<double> roots;
    const double discriminant = c1 * c1 - 4 * c2 * c0, scale = c1 * c1 + std::abs(4 * c2 * c0);
    if (std::abs(c2) < 1e-12 * std::abs(c1)) roots = {-c0 / c1};
    else if (discriminant >= -1e-6 * scale) {
        const double root = -0.5 * (c1 + std::copysign(std::sqrt(std::max(discriminant, 0.0)), c1));
        roots = {root / c2, root != 0 ? c0 / root : 0};
    }
    const bool grazing = discriminant < 1e-3 * scale && std::abs(c2) >= 1e-12 * std::abs(c1);
    for (double u : roots) {
        const glm::dvec3 base = A + u * B, line = C + u * D, across = glm::cross(d, line);
        const double length2 = glm::dot(across, across);
        if (length2 == 0) continue;
        const double v = glm::dot(glm::cross(base, d), across) / length2, t = glm::dot(glm::cross(base, line), across) / length2;
        const double cosine = std::sqrt(length2) / (glm::length(d) * glm::length(line));
        const double margin = std::min({u, 1 - u, v, 1 - v});
        found.push_back({t, element, instance, grazing || cosine < 0.05 ? std::min(margin, 0.0) : margin, (grazing ? 0.1 : 1e-4) * std::max(1.0, glm::length(o)) / glm::length(d) / std::max(cosine, 1e-3)});
    }
}

void BruteForce::meetElement(uint element, uint instance, glm::dvec3 o, glm::dvec3 d, std::vector<Candidate>& found) const {
    const SceneTables& tables = scene_.tables;
    const shape& s = tables.shapes[tables.element_shapes[element]];
    const auto corner = [&](uint k, uint count) { return toGlm(tables.positions[s.first_vertex + tables.indices[s.first_index + count * (element - s.first_element) + k]]); };
    if (s.kind == shape_triangle) { meetTriangle(corner(0, 3), corner(1, 3), corner(2, 3), o, d, element, instance, found); return; }
    if (s.kind == shape_bilinear) {
        const glm::dvec3 p[4] = {corner(0, 4), corner(1, 4), corner(2, 4), corner(3, 4)};
        meetPatch(p, o, d, element, instance, found);
        return;
    }
    const quadric& q = tables.quadrics[s.quadric];
    const glm::dvec3 oo = mapPoint(q.object_from_scene, o), od = mapVector(q.object_from_scene, d);
    if (s.kind == shape_sphere) meetSphere(q, oo, od, element, instance, found);
    else meetDisk(q, oo, od, element, instance, found);
}

void BruteForce::meetGroup(const Group& group, uint instance, glm::dvec3 o, glm::dvec3 d, std::vector<Candidate>& found) const {
    std::vector<Candidate> all;
    for (uint e : group.elements) meetElement(e, instance, o, d, all);
    for (const Candidate& c : all)
        if (c.margin > -1 && c.t > -c.tolerance) found.push_back(c);
}

std::vector<Candidate> BruteForce::meet(vec3 o, vec3 d) const {
    std::vector<Candidate> found;
    meetGroup(world_, NONE, toGlm(o), toGlm(d), found);
    for (uint i : placed_) {
        const affine& m = scene_.tables.instances[i].object_from_scene;
        meetGroup(objects_[i], i, mapPoint(m, toGlm(o)), mapVector(m, toGlm(d)), found);
    }
    return found;
}

/// What is near a ray's end: candidates in the order of their distance from it.
static std::string describe(const std::vector<Candidate>& all, double end) {
    std::vector<Candidate> sorted = all;
    std::sort(sorted.begin(), sorted.end(), [end](const Candidate& a, const Candidate& b) { return std::abs(a.t - end) < std::abs(b.t - end); });
    std::string text;
    for (size_t i = 0; i < sorted.size() && i < 5; ++i)
        text += fmt::format("\n  element {} instance {} at t {} margin {} tolerance {}", sorted[i].element, static_cast<int>(sorted[i].instance), sorted[i].t, sorted[i].margin, sorted[i].tolerance);
    return text;
}

std::string judgeHit(const std::vector<Candidate>& all, uint element, uint instance, double t) {
    const double reached = element == NONE ? 1e29 : t;
    for (const Candidate& c : all)
        if (c.margin > BruteForce::slack && c.t > c.tolerance && c.t + c.tolerance < reached) return fmt::format("missed an element; found {} at {}", static_cast<int>(element), t) + describe(all, t);
    if (element == NONE) return {};
    for (const Candidate& c : all)
        if (c.element == element && c.instance == instance && c.margin > -BruteForce::slack && std::abs(c.t - t) <= c.tolerance) return {};
    return fmt::format("found element {} instance {} at {}, where it is not", static_cast<int>(element), static_cast<int>(instance), t) + describe(all, t);
}

std::string judgeShadow(const std::vector<Candidate>& all, double tMax, bool blocked) {
    for (const Candidate& c : all) {
        if (blocked && c.margin > -BruteForce::slack && c.t - c.tolerance < tMax) return {};
        if (!blocked && c.margin > BruteForce::slack && c.t > c.tolerance && c.t + c.tolerance < tMax) return "passed through an element" + describe(all, tMax);
    }
    return blocked ? "blocked by nothing" + describe(all, tMax) : std::string();
}

}  // namespace eikonal
