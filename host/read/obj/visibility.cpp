#include "read/obj/visibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace eikonal {
namespace {

constexpr int pixels = 96;  // per side
/// Tests of a pixel in a triangle, for one view; some tenths of a second. Ordinary models take a thousandth.
constexpr std::size_t mostTests = 20'000'000;

/// The closest triangle of each pixel. Depth is measured along the viewing direction.
class DepthBuffer {
public:
    DepthBuffer() : depth_(pixels * pixels, std::numeric_limits<float>::infinity()), triangle_(pixels * pixels, -1) {}

    /// Draws a convex polygon of up to four corners in camera space (x right, y up, z forward), all with z > 0. plane: dot(plane, p) = 1
    /// for the points p of its plane.
    void draw(const glm::vec3* corners, int count, const glm::vec3& plane, float scale, int triangle) {
        std::array<glm::vec2, 4> p;
        glm::vec2 low(pixels), high(0);
        for (int i = 0; i < count; ++i) {
            p[static_cast<std::size_t>(i)] = glm::vec2(corners[i].x, corners[i].y) / corners[i].z * scale + pixels / 2.f;
            low = glm::min(low, p[static_cast<std::size_t>(i)]);
            high = glm::max(high, p[static_cast<std::size_t>(i)]);
        }
        const int x0 = clampPixel(low.x - .5f), x1 = clampPixel(high.x + .5f), y0 = clampPixel(low.y - .5f), y1 = clampPixel(high.y + .5f);
        tests_ += static_cast<std::size_t>(std::max(x1 - x0, 0)) * static_cast<std::size_t>(std::max(y1 - y0, 0));
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                const glm::vec2 q(static_cast<float>(x) + .5f, static_cast<float>(y) + .5f);
                bool allLeft = true, allRight = true;
                for (int i = 0; i < count; ++i) {
                    const glm::vec2 a = p[static_cast<std::size_t>(i)], b = p[static_cast<std::size_t>((i + 1) % count)];
                    const float side = (b.x - a.x) * (q.y - a.y) - (b.y - a.y) * (q.x - a.x);
                    allLeft = allLeft && side >= 0;
                    allRight = allRight && side <= 0;
                }
                if (!allLeft && !allRight) continue;
                const float inverse = glm::dot(plane, ray(x, y, scale));
                const std::size_t i = static_cast<std::size_t>(y) * pixels + static_cast<std::size_t>(x);
                if (inverse <= 0 || 1 / inverse >= depth_[i]) continue;
                depth_[i] = 1 / inverse;
                triangle_[i] = triangle;
            }
    }

    /// The direction through a pixel's centre, with z = 1.
    static glm::vec3 ray(int x, int y, float scale) {
        return {(static_cast<float>(x) + .5f - pixels / 2.f) / scale, (static_cast<float>(y) + .5f - pixels / 2.f) / scale, 1};
    }
    float depth(std::size_t i) const { return depth_[i]; }
    int triangle(std::size_t i) const { return triangle_[i]; }
    /// Pixels that draw() has tested so far.
    std::size_t tests() const { return tests_; }

private:
    static int clampPixel(float x) { return static_cast<int>(std::clamp(std::ceil(x), 0.f, static_cast<float>(pixels))); }

    std::vector<float> depth_;
    std::vector<int> triangle_;
    std::size_t tests_ = 0;
};

/// Clips a triangle at z = nearest; returns the number of remaining corners, at most four.
int clip(const std::array<glm::vec3, 3>& triangle, float nearest, std::array<glm::vec3, 4>& result) {
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3 &a = triangle[i], &b = triangle[(i + 1) % 3];
        if (a.z >= nearest) result[static_cast<std::size_t>(count++)] = a;
        if ((a.z >= nearest) != (b.z >= nearest)) result[static_cast<std::size_t>(count++)] = glm::mix(a, b, (nearest - a.z) / (b.z - a.z));
    }
    return count;
}

}  // namespace

double visibleFraction(const std::vector<ViewedTriangle>& triangles, const View& view, double behindCredit) {
    const glm::dmat4 cameraFromWorld = glm::inverse(worldFromCamera(view));
    const float scale = static_cast<float>(pixels / 2. / std::tan(view.fov / 2 * std::numbers::pi / 180));
    const float nearest = static_cast<float>(1e-4 * glm::distance(view.eye, view.target));
    const auto toCamera = [&](const glm::vec3& p) { return glm::vec3(cameraFromWorld * glm::dvec4(p, 1)); };

    std::uint32_t shapes = 0;
    for (const ViewedTriangle& t : triangles) shapes = std::max(shapes, t.shape + 1);
    std::vector<double> area(shapes, 0.), visible(shapes, 0.);

    DepthBuffer buffer;
    for (std::size_t i = 0; i < triangles.size() && buffer.tests() < mostTests; ++i) {
        const std::array<glm::vec3, 3> p{toCamera(triangles[i].a), toCamera(triangles[i].b), toCamera(triangles[i].c)};
        const glm::vec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
        area[triangles[i].shape] += glm::length(normal) / 2;
        const float height = glm::dot(normal, p[0]);
        std::array<glm::vec3, 4> corners;
        const int count = clip(p, nearest, corners);
        if (count >= 3 && height != 0) buffer.draw(corners.data(), count, normal / height, scale, static_cast<int>(i));
    }

    // A pixel's cone of solid angle 1 / scale^2 / |ray|^3 covers depth^2 / (scale^2 |cos|) of a surface; cos is between its normal and the
    // ray of z = 1.
    for (int y = 0; y < pixels; ++y)
        for (int x = 0; x < pixels; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * pixels + static_cast<std::size_t>(x);
            if (buffer.triangle(i) < 0) continue;
            const ViewedTriangle& t = triangles[static_cast<std::size_t>(buffer.triangle(i))];
            const glm::vec3 a = toCamera(t.a), normal = glm::normalize(glm::cross(toCamera(t.b) - a, toCamera(t.c) - a));
            // Camera space is mirrored, so a triangle that faces the camera has a normal along the ray.
            const float cosine = glm::dot(normal, DepthBuffer::ray(x, y, scale));
            const double cutOut = std::pow(buffer.depth(i) / scale, 2) / std::max(std::abs(cosine), .05f);
            visible[t.shape] += cutOut * (cosine > 0 ? 1 : behindCredit);
        }

    double sum = 0;
    int counted = 0;
    for (std::uint32_t s = 0; s < shapes; ++s) {
        if (area[s] <= 0) continue;
        sum += std::min(1., visible[s] / area[s]);
        ++counted;
    }
    return counted ? sum / counted : 0;
}

}  // namespace eikonal
