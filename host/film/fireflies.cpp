#include "film/fireflies.h"

#include "color/luminance.h"
#include "eikonal/film.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace eikonal {
namespace {

/// A band counts in full once so many samples of its brightness are found; one sample alone does not count.
constexpr double trusted = 4;
/// A single sample does no harm if it adds at most this share of the light of darker bands.
constexpr double harmless = 0.25;

constexpr std::size_t bandCount = BRIGHTNESS_BANDS;
using Bands = std::array<double, bandCount>;

std::array<double, bandCount> bandLevels() {
    std::array<double, bandCount> levels;
    for (std::size_t k = 0; k < bandCount; ++k) levels[k] = k ? levels[k - 1] * double{BAND_RATIO} : double{LEAST_BRIGHTNESS};
    return levels;
}

}  // namespace

std::vector<glm::vec3> firefliesIn(const BrightnessBands& bands) {
    const std::size_t n = bands.width * bands.height;
    const Bands levels = bandLevels();
    const auto colorOf = [&](std::size_t band, std::size_t i) {
        const float* const sum = bands.sums + band * GROUP_WORDS * n + i;
        return glm::vec3(sum[0], sum[n], sum[2 * n]);
    };
    /* Luminances of the bands, summed over samples and not yet divided by their number */
    std::vector<Bands> sums(n);
    tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) {
        for (std::size_t k = 0; k < bandCount; ++k) sums[i][k] = std::max(double{luminance(colorOf(k, i))}, 0.0);
    });
    std::vector<glm::vec3> taken(n, glm::vec3(0));
    tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) {
        if (bands.weights[i] == 0) return;
        const std::size_t x = i % bands.width, y = i / bands.width;
        Bands around{};
        double weights = 0;
        for (std::size_t v = y ? y - 1 : 0; v <= std::min(y + 1, bands.height - 1); ++v)
            for (std::size_t u = x ? x - 1 : 0; u <= std::min(x + 1, bands.width - 1); ++u) {
                const std::size_t j = v * bands.width + u;
                weights += double{bands.weights[j]};
                for (std::size_t k = 0; k < bandCount; ++k) around[k] += sums[j][k];
            }
        glm::vec3 sum(0);
        double kept = around[0];
        for (std::size_t k = 1; k < bandCount; ++k) {
            /* How many samples there are of about this brightness, and how much one adds to a pixel beside darker light */
            const double found = (around[k] + around[k - 1]) / levels[k];
            const double single = levels[k] / double{bands.weights[i]}, darker = kept / weights;
            const double share = std::clamp(std::max((found - 1) / (trusted - 1), harmless * darker / single), 0.0, 1.0);
            sum += colorOf(k, i) * static_cast<float>(1 - share);
            kept += around[k] * share;
        }
        taken[i] = sum / bands.weights[i];
    });
    return taken;
}

double firefliesShare(const std::vector<glm::vec3>& fireflies, const std::vector<glm::vec3>& color) {
    double taken = 0, left = 0;
    for (const glm::vec3& c : fireflies) taken += double{luminance(c)};
    for (const glm::vec3& c : color) left += double{luminance(c)};
    return taken > 0 ? std::min(taken / (taken + std::max(left, 0.0)), 1.0) : 0;
}

}  // namespace eikonal
