#include "image/sample_variance.h"

#include "color/luminance.h"

#include <algorithm>
#include <limits>

namespace eikonal {

void addSampleVariance(FilmImage& image, double samples) {
    const auto stored = [](glm::dvec3 v) { return glm::vec3(glm::min(v, glm::dvec3(std::numeric_limits<float>::max()))); };
    const std::size_t pixels = image.variance.size();
    image.sampleVariance.resize(pixels);
    image.relativeVariance.resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const glm::dvec3 mean(glm::max(image.color[i], 0.f));
        const double brightness = luminance(mean);
        if (!(brightness > 0)) continue;
        const double ofLuminance = image.variance[i] * (image.sampleCount.empty() ? samples : image.sampleCount[i]);
        const glm::dvec3 share = mean / brightness;
        image.sampleVariance[i] = stored(ofLuminance * share * share);
        image.relativeVariance[i] = stored(ofLuminance * share / brightness);
    }
}

}  // namespace eikonal
