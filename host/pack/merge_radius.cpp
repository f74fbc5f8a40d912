#include "pack/merge_radius.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace eikonal {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

float squaredDistance(const vec3& a, const vec3& b) {
    const float x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return x * x + y * y + z * z;
}
float dot(const vec3& a, const vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

float median(std::vector<float> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// How many neighbours tell how densely light vertices lie around a point, and at how many points that is asked.
constexpr size_t neighbours = 4, mostAsked = 512;

/// The distance within which `neighbours` light vertices lie that merge at a point, squared; the median over the points that are seen.
float squaredReach(const SurfacePoints& seen, const SurfacePoints& lit) {
    std::vector<float> reaches(std::min(seen.points.size(), mostAsked));
    for (size_t i = 0; i < reaches.size(); ++i) {
        std::array<float, neighbours> nearest;
        nearest.fill(infinity);
        for (size_t j = 0; j < lit.points.size(); ++j) {
            const float square = squaredDistance(seen.points[i], lit.points[j]);
            if (!(square < nearest.back()) || std::abs(dot(seen.normals[i], lit.normals[j])) <= 0.7f) continue;
            nearest.back() = square;
            for (size_t k = neighbours - 1; k > 0 && nearest[k] < nearest[k - 1]; --k) std::swap(nearest[k], nearest[k - 1]);
        }
        reaches[i] = nearest.back();
    }
    return median(std::move(reaches));
}

}  // namespace

std::optional<double> surfaceOf(std::vector<vec3> points) {
    constexpr size_t fewest = 16;
    const auto order = [](const vec3& p) { return std::tie(p.x, p.y, p.z); };
    std::ranges::sort(points, {}, order);
    const auto again = std::ranges::unique(points, {}, order);
    points.erase(again.begin(), again.end());
    if (points.size() < fewest) return {};
    std::vector<float> nearest(points.size(), infinity);
    for (size_t i = 0; i < points.size(); ++i) {
        for (size_t j = 0; j < i; ++j) {
            const float square = squaredDistance(points[i], points[j]);
            nearest[i] = std::min(nearest[i], square);
            nearest[j] = std::min(nearest[j], square);
        }
    }
    return double{median(std::move(nearest))} * std::numbers::pi / std::numbers::ln2 * static_cast<double>(points.size());
}

std::optional<double> chooseMergeRadius(const MergeView& view, double pixels, double lightPaths, double most) {
    constexpr double widest = 3, fewestVertices = 1;
    const std::optional<double> surface = surfaceOf(view.seen.points);
    if (!surface || view.lightPaths == 0) return {};
    const double share = static_cast<double>(view.seen.points.size()) / static_cast<double>(view.cameraPaths),   // of the image
                 sharp = widest * std::sqrt(*surface / (share * pixels)),
                 more = lightPaths / static_cast<double>(view.lightPaths),   // as many times as many vertices in a pass
                 smooth = std::sqrt(double{squaredReach(view.seen, view.lit)} * fewestVertices / (double{neighbours} * more));
    return std::clamp(smooth, std::min(sharp, most), most);
}

}  // namespace eikonal
