#include "film/projection.h"

#include "kinds/camera_kind.h"
#include "pack/space.h"

#include <array>
#include <cmath>

namespace eikonal {

std::optional<glm::dvec2> pixelOf(const PackedScene& scene, glm::dvec3 p) {
    const camera& view = scene.frame().view;
    const std::optional<glm::dvec2> screen = kindOf(view).traits.project(scene, p / scene.cameraUnit);
    if (!screen) return std::nullopt;
    return (*screen - glm::dvec2(view.screen_x, view.screen_y)) / glm::dvec2(view.step_x, view.step_y);
}

/// The offset in pixels from one point of the image to another. If the image wraps around, the shorter way.
static glm::dvec2 wayInImage(const PackedScene& scene, glm::dvec2 from, glm::dvec2 to) {
    glm::dvec2 way = to - from;
    const camera& view = scene.frame().view;
    const double width = scene.frame().width;
    const auto wrapsAround = kindOf(view).traits.wrapsAround;
    if (wrapsAround && wrapsAround(view)) way.x -= width * std::round(way.x / width);
    return way;
}

glm::dvec2 motionInImage(const PackedScene& scene, glm::dvec3 opening, glm::dvec3 closing) {
    const auto& [open, middle, close] = scene.cameraFromScene;
    const auto from = pixelOf(scene, transformPoint(open, opening)), to = pixelOf(scene, transformPoint(close, closing));
    return from && to ? wayInImage(scene, *from, *to) : glm::dvec2(0);
}

glm::dvec2 depthSlope(const PackedScene& scene, glm::dvec3 p, glm::dvec3 n) {
    const glm::dmat4& cameraFromScene = scene.cameraFromScene[1];
    const glm::dvec3 at = transformPoint(cameraFromScene, p), normal = transformNormal(cameraFromScene, n);
    if (!(glm::length(normal) > 0)) return glm::dvec2(0);

    /* Choose two tangent directions of the plane, and differentiate their image positions */
    constexpr double relativeStep = 1e-5;
    const glm::dvec3 aside =
        glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.5 * glm::length(normal) ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const std::array along{aside, glm::normalize(glm::cross(normal, aside))};
    std::array<glm::dvec2, 2> way;
    const double step = relativeStep * glm::length(at);
    for (int k : {0, 1}) {
        const auto from = pixelOf(scene, at - step * along[k]), to = pixelOf(scene, at + step * along[k]);
        if (!from || !to) return glm::dvec2(0);
        way[k] = wayInImage(scene, *from, *to) / (2 * step);
    }

    /* Solve for the steps of one pixel to the right and one pixel down (Cramer's rule) */
    const double determinant = way[0].x * way[1].y - way[0].y * way[1].x;
    const glm::dvec2 slope =
        glm::dvec2(way[1].y * along[0].z - way[0].y * along[1].z, way[0].x * along[1].z - way[1].x * along[0].z) / determinant;
    return std::isfinite(slope.x) && std::isfinite(slope.y) ? glm::abs(slope) : glm::dvec2(0);
}

static glm::dmat4 sceneFromWorld(const PackedScene& scene) {
    return SceneSpace{scene.worldCenter, 1 / scene.worldScale}.sceneFromWorld();
}

glm::dmat4 cameraFromWorld(const PackedScene& scene) { return scene.cameraFromScene[0] * sceneFromWorld(scene); }

void toCameraSpace(FilmImage& image, const PackedScene& scene) {
    const glm::dmat4 cameraFromWorld = scene.cameraFromScene[1] * sceneFromWorld(scene);
    for (size_t i = 0; i < image.position.size(); ++i)
        if (image.depth.empty() || std::isfinite(image.depth[i]))
            image.position[i] = glm::vec3(transformPoint(cameraFromWorld, image.position[i]));
    for (auto* normals : {&image.normal, &image.geometricNormal})
        for (glm::vec3& n : *normals) n = glm::vec3(transformNormal(cameraFromWorld, n));
}

}  // namespace eikonal
