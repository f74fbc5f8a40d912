#include "color/uplift_table.h"

#include "eikonal/scene.h"

#include <algorithm>

namespace eikonal {
namespace {

constexpr float coefficients[] = {
#include "uplift_table.inc"
};

}  // namespace

std::span<const float> upliftTable() { return coefficients; }

SmoothReflectance tabulatedReflectance(glm::dvec3 rgb) {
    constexpr int cells = UPLIFT_CELLS;
    static_assert(std::size(coefficients) == static_cast<size_t>(3 * 3) * cells * cells * cells);
    if (rgb.x == rgb.y && rgb.y == rgb.z) return upliftGrey(rgb.x);
    const int channel = rgb.x >= rgb.y && rgb.x >= rgb.z ? 0 : rgb.y >= rgb.z ? 1 : 2;
    const double largest = rgb[channel], x = rgb[(channel + 1) % 3] / largest * (cells - 1),
                 y = rgb[(channel + 2) % 3] / largest * (cells - 1);
    int z = 0;
    while (z + 2 < cells && upliftNode(z + 1) <= largest) ++z;
    const int ix = std::min(static_cast<int>(x), cells - 2), iy = std::min(static_cast<int>(y), cells - 2);
    const double fx = x - ix, fy = y - iy, fz = (largest - upliftNode(z)) / (upliftNode(z + 1) - upliftNode(z));
    SmoothReflectance result;
    for (int corner = 0; corner < 8; ++corner) {
        const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
        const double weight = (dx ? fx : 1 - fx) * (dy ? fy : 1 - fy) * (dz ? fz : 1 - fz);
        const size_t at = static_cast<size_t>((((channel * cells + z + dz) * cells + iy + dy) * cells + ix + dx) * 3);
        result.c += weight * glm::dvec3(coefficients[at], coefficients[at + 1], coefficients[at + 2]);
    }
    return result;
}

}  // namespace eikonal
