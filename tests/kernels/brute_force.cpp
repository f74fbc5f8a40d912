#include "brute_force.h"

#include "eikonal/shapes.h"
#include "leaf_triangles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eikonal {

static glm::dvec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }
static glm::dvec3 mapPoint(const affine& m, glm::dvec3 p) {
    return {m.xx * p.x + m.xy * p.y + m.xz * p.z + m.xw, m.yx * p.x + m.yy * p.y + m.yz * p.z + m.yw,
            m.zx * p.x + m.zy * p.y + m.zz * p.z + m.zw};
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
        const uint kind = (ref >> LEAF_KIND_SHIFT) & LEAF_KIND_MASK, count = ((ref >> LEAF_COUNT_SHIFT) & LEAF_COUNT_MASK) + 1,
                   first = ref & LEAF_FIRST_MASK;
        if (kind == leaf_triangles) {
            for (const LeafTriangle& triangle : leafTriangles(tables.triangle_lines, ref)) group.elements.push_back(triangle.element);
        } else if (kind == leaf_elements)
            group.elements.insert(group.elements.end(), &tables.leaf_elements[first], &tables.leaf_elements[first] + count);
        else instances->push_back(first);
    }
}

vec3 placedCenter(const object_space& q) {
    const glm::dvec3 p = mapPoint(q.scene_from_object, toGlm(q.center));
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// Cramer's rule; margin is the least barycentric coordinate.
static void meetTriangle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 o, glm::dvec3 d, uint element, uint instance,
                         std::vector<Candidate>& found) {
    const glm::dvec3 ab = b - a, ac = c - a, n = glm::cross(ab, ac), ao = o - a;
    const double determinant = -glm::dot(d, n);
    if (determinant == 0 || glm::length(n) == 0) return;
    const glm::dvec3 q = glm::cross(ao, d);
    const double u = glm::dot(ac, q) / determinant, v = -glm::dot(ab, q) / determinant, t = glm::dot(ao, n) / determinant;
    /* Seen edge-on, coordinates and distance are uncertain by the inverse of the cosine */
    const double cosine = std::abs(determinant) / (glm::length(n) * glm::length(d)),
                 size = std::max({glm::length(ab), glm::length(ac), glm::length(b - c)});
    const double reach = std::max({1.0, glm::length(a), glm::length(o)}) / glm::length(d);
    const double blur = 1e-6 * glm::length(d) * reach * size / glm::length(n) / cosine;
    found.push_back({t, element, instance, std::min({u, v, 1 - u - v}) / std::max(1.0, blur / BruteForce::slack), 2e-5 * reach / cosine});
}

static void meetSphere(const object_space& q, glm::dvec3 o, glm::dvec3 d, uint element, uint instance, std::vector<Candidate>& found) {
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

static void meetDisk(const object_space& q, glm::dvec3 o, glm::dvec3 d, uint element, uint instance, std::vector<Candidate>& found) {
    if (d.z == 0) return;
    const double t = (q.z_min - q.center.z - o.z) / d.z;
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

static void meetCylinder(const object_space& q, glm::dvec3 o, glm::dvec3 d, uint element, uint instance, std::vector<Candidate>& found) {
    const double a = d.x * d.x + d.y * d.y, r = q.radius, sine2 = a / glm::dot(d, d);
    if (a == 0) return;
    const double b = -(o.x * d.x + o.y * d.y) / a, nearest = std::hypot(o.x + b * d.x, o.y + b * d.y);
    const double inside = (r * r - nearest * nearest) / (r * r);
    if (inside < -1e-3) return;
    /* Along the axis, or where it grazes, a ray may hit or miss */
    const double half = std::sqrt(std::max(inside, 0.0)) * r / std::sqrt(a),
                 blur = 2e-5 * std::max(1.0, glm::length(o)) / std::sqrt(a) / std::sqrt(sine2);
    for (double t : {b - half, b + half}) {
        const glm::dvec3 p = o + t * d;
        double margin = inside < 2e-3 || sine2 < 1e-3 ? 0 : inside;
        margin = std::min({margin, (p.z - q.z_min) / r, (q.z_max - p.z) / r});
        if (q.phi_max < static_cast<float>(2 * M_PI)) {
            double phi = std::atan2(p.y, p.x);
            if (phi < 0) phi += 2 * M_PI;
            margin = std::min({margin, phi <= q.phi_max ? std::min(phi, q.phi_max - phi) : -std::min(2 * M_PI - phi, phi - q.phi_max)});
        }
        found.push_back({t, element, instance, margin, blur + (inside < 1e-2 ? 0.1 * r / std::sqrt(a) : 0)});
    }
}

/// Where the curve, seen along the ray, is nearest to it: that is a hit if the strip is wide enough there. By bisection of the product of
/// distance and tangent, from steps of an eighth of a piece of the device's.
static void meetCurve(const curve& c, uint splits, uint firstElement, glm::dvec3 o, glm::dvec3 d, uint instance,
                      std::vector<Candidate>& found) {
    const glm::dvec3 w = glm::normalize(d), p[4] = {toGlm(c.p[0]) - o, toGlm(c.p[1]) - o, toGlm(c.p[2]) - o, toGlm(c.p[3]) - o};
    const double reach = glm::length(p[1] - p[0]) + glm::length(p[2] - p[1]) + glm::length(p[3] - p[2]) +
                         static_cast<double>(std::max(c.width[0], c.width[1]));
    const auto across = [&](glm::dvec3 v) { return v - glm::dot(v, w) * w; };
    if (glm::length(across(p[0])) > reach) return;
    const auto point = [&](double u) {
        const double s = 1 - u;
        return s * s * s * p[0] + 3 * s * s * u * p[1] + 3 * s * u * u * p[2] + u * u * u * p[3];
    };
    const auto tangent = [&](double u) {
        const double s = 1 - u;
        return s * s * (p[1] - p[0]) + 2 * s * u * (p[2] - p[1]) + u * u * (p[3] - p[2]);
    };
    const auto slope = [&](double u) { return glm::dot(across(point(u)), across(tangent(u))); };

    constexpr double beyond = 1e-3;   /* of both ends: there a hit is possible, since ends round */
    const double step = std::ldexp(1.0, -static_cast<int>(splits) - 6);
    const auto within = [&](double from, double to) {   /* a bound on how far the curve gets from its middle, plus the strip */
        const double speed = 3 * std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[3] - p[2])});
        return glm::length(across(point(0.5 * (from + to)))) <=
               speed * 0.6 * (to - from) + static_cast<double>(std::max(c.width[0], c.width[1]));
    };
    std::vector<double> starts;
    for (double from = -beyond; from < 1 + beyond; from += 1.0 / 16)
        if (within(from, from + 1.0 / 16))
            for (double u = from; u < from + 1.0 / 16; u += step) starts.push_back(u);
    for (double u : starts) {
        double low = u, high = u + step;
        if (slope(low) > 0 || slope(high) < 0) continue;
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (low + high);
            (slope(middle) > 0 ? high : low) = middle;
        }
        const double width = [&] {
            const double plain = glm::mix(static_cast<double>(c.width[0]), static_cast<double>(c.width[1]), low);
            if (c.type != curve_ribbon) return plain;
            const double angle = c.normal_angle;
            const glm::dvec3 n =
                angle == 0 ? toGlm(c.n[0])
                           : (std::sin((1 - low) * angle) * toGlm(c.n[0]) + std::sin(low * angle) * toGlm(c.n[1])) / std::sin(angle);
            return plain * std::abs(glm::dot(n, w));
        }();
        /* The device takes the nearest point of a chord for that of the curve: near the edge, at the ends, edge-on and where the curve runs
           along the ray, it may decide otherwise */
        double margin = 1 - 2 * glm::length(across(point(low))) / std::max(width, 1e-9);
        const double piece = 8 * step, start = std::floor(low / piece) * piece;
        const glm::dvec3 t0 = across(tangent(start)), t1 = across(tangent(start + piece));
        const double turn = glm::dot(t0, t1) / std::max(glm::length(t0) * glm::length(t1), 1e-30);
        const bool vague = low < beyond || low > 1 - beyond || width < 1e-4 || turn < 0.9 ||
                           glm::length(across(tangent(low))) < 0.2 * glm::length(tangent(low));
        if (std::abs(margin) < 0.1 || (vague && margin > 0)) margin = 0;
        const double depth = glm::dot(point(low), w), change = std::abs(glm::dot(point(start + piece) - point(start), w));
        const double tolerance = ((vague ? 2 : 0.2) * change + 2e-5 * std::max(1.0, glm::length(o))) / glm::length(d);
        const double part = std::ldexp(std::clamp(low, 0.0, 1 - 1e-12), static_cast<int>(splits));
        const auto candidate = [&](double at, double m) {
            found.push_back({depth / glm::length(d), firstElement + static_cast<uint>(at), instance, m, tolerance});
        };
        candidate(part, margin);
        for (const double side : {-1e-3, 1e-3})
            if (std::floor(part + side) != std::floor(part) && part + side >= 0 && std::ldexp(part + side, -static_cast<int>(splits)) < 1)
                candidate(part + side, std::min(margin, 0.0));
    }
}

/// Roots of a quadratic in u, then v and t on the line of constant u, by least squares.
static void meetPatch(const glm::dvec3 (&p)[4], glm::dvec3 o, glm::dvec3 d, uint element, uint instance, std::vector<Candidate>& found) {
    /* (A + u B) + v (C + u D) - t d = 0 with A = p00 - o: the triple product of both parts with d vanishes */
    const glm::dvec3 A = p[0] - o, B = p[1] - p[0], C = p[2] - p[0], D = p[3] - p[2] - p[1] + p[0];
    const double c0 = glm::dot(glm::cross(A, d), C), c1 = glm::dot(glm::cross(A, d), D) + glm::dot(glm::cross(B, d), C),
                 c2 = glm::dot(glm::cross(B, d), D);
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
        found.push_back({t, element, instance, grazing || cosine < 0.05 ? std::min(margin, 0.0) : margin,
                         (grazing ? 0.1 : 1e-4) * std::max(1.0, glm::length(o)) / glm::length(d) / std::max(cosine, 1e-3)});
    }
}

void BruteForce::meetElement(uint element, uint instance, glm::dvec3 o, glm::dvec3 d, std::vector<Candidate>& found) const {
    const SceneTables& tables = scene_.tables;
    const shape& s = tables.shapes[tables.element_shapes[element]];
    const auto corner = [&](uint k, uint count) {
        return toGlm(tables.positions[s.first_vertex + tables.indices[s.first_index + count * (element - s.first_element) + k]]);
    };
    if (s.kind == shape_triangle) { meetTriangle(corner(0, 3), corner(1, 3), corner(2, 3), o, d, element, instance, found); return; }
    if (s.kind == shape_bilinear) {
        const glm::dvec3 p[4] = {corner(0, 4), corner(1, 4), corner(2, 4), corner(3, 4)};
        meetPatch(p, o, d, element, instance, found);
        return;
    }
    if (s.kind == shape_curve) {
        /* All parts of a segment at once, with the first */
        const uint number = element - s.first_element, parts = 1u << s.splits;
        if (number % parts) return;
        const bool mapped = s.object_space != NONE;
        const affine* m = mapped ? &tables.object_spaces[s.object_space].object_from_scene : nullptr;
        meetCurve(tables.curve_segments[s.first_index + number / parts], s.splits, element, mapped ? mapPoint(*m, o) : o,
                  mapped ? mapVector(*m, d) : d, instance, found);
        return;
    }
    const object_space& q = tables.object_spaces[s.object_space];
    const glm::dvec3 oo = mapPoint(q.object_from_scene, o) - toGlm(q.center), od = mapVector(q.object_from_scene, d);
    if (s.kind == shape_sphere) meetSphere(q, oo, od, element, instance, found);
    else if (s.kind == shape_cylinder) meetCylinder(q, oo, od, element, instance, found);
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
    std::sort(sorted.begin(), sorted.end(),
              [end](const Candidate& a, const Candidate& b) { return std::abs(a.t - end) < std::abs(b.t - end); });
    std::string text;
    for (size_t i = 0; i < sorted.size() && i < 5; ++i)
        text += fmt::format("\n  element {} instance {} at t {} margin {} tolerance {}", sorted[i].element,
                            static_cast<int>(sorted[i].instance), sorted[i].t, sorted[i].margin, sorted[i].tolerance);
    return text;
}

std::string judgeHit(const std::vector<Candidate>& all, uint element, uint instance, double t) {
    const double reached = element == NONE ? 1e29 : t;
    for (const Candidate& c : all)
        if (c.margin > BruteForce::slack && c.t > c.tolerance && c.t + c.tolerance < reached)
            return fmt::format("missed an element; found {} at {}", static_cast<int>(element), t) + describe(all, t);
    if (element == NONE) return {};
    for (const Candidate& c : all)
        if (c.element == element && c.instance == instance && c.margin > -BruteForce::slack && std::abs(c.t - t) <= c.tolerance) return {};
    return fmt::format("found element {} instance {} at {}, where it is not", static_cast<int>(element), static_cast<int>(instance), t) +
           describe(all, t);
}

std::string judgeShadow(const std::vector<Candidate>& all, double tMax, bool blocked) {
    for (const Candidate& c : all) {
        if (blocked && c.margin > -BruteForce::slack && c.t - c.tolerance < tMax) return {};
        if (!blocked && c.margin > BruteForce::slack && c.t > c.tolerance && c.t + c.tolerance < tMax)
            return "passed through an element" + describe(all, tMax);
    }
    return blocked ? "blocked by nothing" + describe(all, tMax) : std::string();
}

}  // namespace eikonal
