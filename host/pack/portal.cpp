#include "pack/portal.h"

#include "color/luminance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eikonal {

using std::numbers::pi;

PortalImage makePortalImage(int resolution, const std::function<glm::dvec3(glm::dvec3)>& radiance) {
    const size_t n = static_cast<size_t>(resolution);
    PortalImage image;
    image.resolution = resolution;
    image.texels.resize(n * n);
    std::vector<double> weights(n * n), luminances(n * n);
    tbb::parallel_for(size_t{0}, n, [&](size_t y) {
        for (size_t x = 0; x < n; ++x) {
            const auto tangent = [&](size_t i) { return std::tan(pi * ((static_cast<double>(i) + 0.5) / static_cast<double>(n) - 0.5)); };
            const glm::dvec3 w = glm::normalize(glm::dvec3(tangent(x), tangent(y), 1));
            const double stretch = pi * pi * (1 - w.x * w.x) * (1 - w.y * w.y) / w.z / static_cast<double>(n * n);
            const glm::dvec3 L = glm::max(radiance(w), glm::dvec3(0));
            image.texels[y * n + x] = L;
            weights[y * n + x] = (L.x + L.y + L.z) / 3 * stretch;
            luminances[y * n + x] = luminance(L) * stretch;
        }
    });

    double total = 0;
    for (double w : weights) total += w;
    for (double l : luminances) image.fluence += l;
    image.sums.assign((n + 1) * (n + 1), 0);
    for (size_t y = 0; y < n; ++y) {
        uint row = 0;
        for (size_t x = 0; x < n; ++x) {
            const double w = weights[y * n + x];
            if (w > 0) row += std::max(1u, static_cast<uint>(std::lround(w / total * 0x1p30)));
            image.sums[(y + 1) * (n + 1) + x + 1] = image.sums[y * (n + 1) + x + 1] + row;
        }
    }
    return image;
}

}  // namespace eikonal
