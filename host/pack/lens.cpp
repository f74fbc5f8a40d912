#include "pack/lens.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace eikonal {

LensSystem::LensSystem(const CameraDescription& camera, double filmDiagonal)
    : filmRadius_(filmDiagonal / 2000), stopHasShape_(camera.aperture != ApertureShape::round) {
    const auto index = [&](size_t i) { return camera.lens[i].eta == 0 ? 1.0 : camera.lens[i].eta; };
    double z = 0;
    for (size_t i = camera.lens.size(); i-- > 0;) {
        const LensElement& e = camera.lens[i];
        z += e.thickness / 1000;
        double aperture = e.apertureDiameter / 2000;
        if (e.curvatureRadius == 0) {
            stopIsTooWide_ |= camera.apertureDiameter > e.apertureDiameter;
            aperture = std::min(aperture, camera.apertureDiameter / 2000);
        }
        elements_.push_back({z, e.curvatureRadius / 1000, aperture, i > 0 ? index(i - 1) / index(i) : 1 / index(i)});
    }
    focus(camera);
}

/// eta: refractive index after the surface over that before it.
std::optional<LensRay> LensSystem::pass(const Element& e, double eta, LensRay ray) const {
    const glm::dvec3 q = ray.o - glm::dvec3(0, 0, e.z), d = ray.d;
    if (e.radius == 0) {
        const double t = -q.z / d.z;
        const glm::dvec3 p = ray.o + t * d;
        const double reach = stopHasShape_ ? std::max(std::abs(p.x), std::abs(p.y)) : std::hypot(p.x, p.y);
        if (t < 0 || reach > e.aperture) return std::nullopt;
        return LensRay{p, d};
    }
    const double b = glm::dot(q, d) + e.radius * d.z, c = glm::dot(q, q) + 2 * e.radius * q.z, discriminant = b * b - c;
    if (discriminant < 0) return std::nullopt;
    const double root = std::copysign(std::sqrt(discriminant), e.radius * d.z), t = b * root > 0 ? -c / (b + root) : root - b;
    const glm::dvec3 p = q + t * d;
    if (t < 0 || std::hypot(p.x, p.y) > e.aperture) return std::nullopt;
    glm::dvec3 n = glm::normalize((p + glm::dvec3(0, 0, e.radius)) / e.radius);
    if (glm::dot(n, d) < 0) n = -n;
    const double cosIn = glm::dot(n, d), squareOut = 1 - (1 - cosIn * cosIn) / (eta * eta);
    if (squareOut <= 0) return std::nullopt;
    return LensRay{p + glm::dvec3(0, 0, e.z), glm::normalize(d / eta + (std::sqrt(squareOut) - cosIn / eta) * n)};
}

/// Rays that turn round, or nearly so, are blocked.
static constexpr double leastCosine = 1e-4;

std::optional<LensRay> LensSystem::fromFilm(LensRay ray) const {
    std::optional<LensRay> r = LensRay{ray.o, glm::normalize(ray.d)};
    for (auto e = elements_.begin(); r && e != elements_.end(); ++e) {
        r = pass(*e, e->eta, *r);
        if (r && r->d.z < leastCosine) return std::nullopt;
    }
    return r;
}

std::optional<LensRay> LensSystem::fromScene(LensRay ray) const {
    std::optional<LensRay> r = LensRay{ray.o, glm::normalize(ray.d)};
    for (auto e = elements_.rbegin(); r && e != elements_.rend(); ++e) {
        r = pass(*e, 1 / e->eta, *r);
        if (r && r->d.z > -leastCosine) return std::nullopt;
    }
    return r;
}

/// Moves the lens so that its thick-lens approximation focuses the focus distance, measured from the film, onto the film.
void LensSystem::focus(const CameraDescription& camera) {
    const double height = 0.002 * filmRadius_;
    const auto fail = [&](const std::string& why) { throw SceneError(camera.where, "the lens " + why); };
    /// z of the principal plane and the focal point, from a ray that enters parallel to the axis.
    struct Cardinal { double plane, focus; };
    const auto cardinal = [&](const std::optional<LensRay>& out) {
        if (!out) fail("blocks all rays near its axis; is the aperture too small?");
        if (out->d.x == 0) fail("has no optical power: rays parallel to its axis stay parallel");
        return Cardinal{out->o.z + (height - out->o.x) / out->d.x * out->d.z, out->o.z - out->o.x / out->d.x * out->d.z};
    };
    const Cardinal film = cardinal(fromScene({{height, 0, elements_.back().z + 1}, {0, 0, -1}}));
    const Cardinal scene = cardinal(fromFilm({{height, 0, elements_.front().z - 1}, {0, 0, 1}}));

    /* 1 / x + 1 / x' = 1 / f for the distances from the principal planes; shifting the lens changes both */
    const double f = film.plane - film.focus, between = camera.focusDistance - scene.plane + film.plane;
    const double c = between * (between - 4 * f);
    if (c <= 0)
        fail(fmt::format("cannot be focused at {} m: with a focal length of {:.4g} mm that takes {:.4g} m at least", camera.focusDistance,
                         f * 1000, 4 * f + scene.plane - film.plane));
    const double shift = (camera.focusDistance - scene.plane - film.plane - std::sqrt(c)) / 2;
    for (Element& e : elements_) e.z += shift;
    if (elements_.front().z <= 0) fail("would have to be behind the film to be focused there");
}

static bool isEmpty(const pupil_bounds& b) { return b.low_x > b.high_x; }

/// Bounds of the rays that pass, from a grid over `over`, enlarged by one step.
template <class Passes> static pupil_bounds boundsOnGrid(const pupil_bounds& over, int steps, Passes&& passes) {
    pupil_bounds found{1, 1, -1, -1};
    const float stepX = (over.high_x - over.low_x) / static_cast<float>(steps),
                stepY = (over.high_y - over.low_y) / static_cast<float>(steps);
    for (int i = 0; i <= steps; ++i)
        for (int k = 0; k <= steps; ++k) {
            const float x = over.low_x + static_cast<float>(i) * stepX, y = over.low_y + static_cast<float>(k) * stepY;
            const bool inside = !isEmpty(found) && x >= found.low_x && x <= found.high_x && y >= found.low_y && y <= found.high_y;
            if (inside || !passes(x, y)) continue;
            found = isEmpty(found) ? pupil_bounds{x, y, x, y}
                                   : pupil_bounds{std::min(found.low_x, x), std::min(found.low_y, y), std::max(found.high_x, x),
                                                  std::max(found.high_y, y)};
        }
    if (isEmpty(found)) return found;
    return {found.low_x - stepX, found.low_y - stepY, found.high_x + stepX, found.high_y + stepY};
}

pupil_bounds LensSystem::pupil(double near, double far) const {
    const double z = rearZ();
    const auto passesFrom = [&](double film) {
        return [this, film, z](float x, float y) {
            return fromFilm({{film, 0, 0}, glm::dvec3(x, y, z) - glm::dvec3(film, 0, 0)}).has_value();
        };
    };
    /* Search an area somewhat larger than the rear element; refine the grid, since the pupil may be small */
    const float reach = 1.5f * static_cast<float>(elements_.front().aperture);
    const pupil_bounds all{-reach, -reach, reach, reach};
    pupil_bounds bounds{1, 1, -1, -1};
    constexpr int films = 4, steps = 48;
    for (int i = 0; i < films; ++i) {
        const auto passes = passesFrom(near + (far - near) * i / (films - 1));
        pupil_bounds here = boundsOnGrid(all, steps, passes);
        if (isEmpty(here)) here = boundsOnGrid(all, 8 * steps, passes);
        if (isEmpty(here)) continue;
        here = boundsOnGrid(here, steps, passes);
        bounds = isEmpty(bounds) ? here
                                 : pupil_bounds{std::min(bounds.low_x, here.low_x), std::min(bounds.low_y, here.low_y),
                                                std::max(bounds.high_x, here.high_x), std::max(bounds.high_y, here.high_y)};
    }
    return bounds;
}

Table<pupil_bounds> LensSystem::pupils() const {
    Table<pupil_bounds> list(PUPIL_INTERVALS);
    tbb::parallel_for(size_t(0), list.size(), [&](size_t i) {
        const double step = filmRadius_ / PUPIL_INTERVALS;
        list[i] = pupil(static_cast<double>(i) * step, static_cast<double>(i + 1) * step);
    });
    return list;
}

LensDisk LensSystem::front(const Table<pupil_bounds>& pupils) const {
    const Element& glass = elements_.back();
    /* A concave surface reaches farther out at its edge than at its vertex */
    const double inner = std::min(glass.aperture, std::abs(glass.radius));
    const double bulge = glass.radius < 0 ? std::abs(glass.radius) - std::sqrt(glass.radius * glass.radius - inner * inner) : 0;
    LensDisk disk{glass.z + bulge + 1e-3 * glass.aperture + 1e-6 * glass.z, 0};
    constexpr int steps = 16;
    for (size_t i = 0; i < pupils.size(); ++i) {
        const pupil_bounds& b = pupils[i];
        const double film = filmRadius_ * (static_cast<double>(i) + 0.5) / static_cast<double>(pupils.size());
        for (int k = 0; k < steps * steps && !isEmpty(b); ++k) {
            const float u = (static_cast<float>(k % steps) + 0.5f) / steps, v = (static_cast<float>(k / steps) + 0.5f) / steps;
            const glm::dvec3 at{b.low_x + u * (b.high_x - b.low_x), b.low_y + v * (b.high_y - b.low_y), rearZ()};
            const auto ray = fromFilm({{film, 0, 0}, at - glm::dvec3(film, 0, 0)});
            /* The disk of a fisheye would be endless */
            if (!ray || ray->d.z < 0.1) continue;
            const glm::dvec3 out = ray->o + (disk.z - ray->o.z) / ray->d.z * ray->d;
            disk.radius = std::max(disk.radius, std::hypot(out.x, out.y));
        }
    }
    /* A grid misses the very edge; without any ray the image is black */
    disk.radius = disk.radius > 0 ? 1.03 * disk.radius : glass.aperture;
    return disk;
}

Table<lens_element> LensSystem::elements() const {
    const auto f = [](double x) { return static_cast<float>(x); };
    Table<lens_element> list;
    for (const Element& e : elements_) list.push_back({f(e.z), f(e.radius), f(e.aperture), f(e.eta)});
    return list;
}

}  // namespace eikonal
