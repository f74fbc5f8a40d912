#include "film/exposure.h"

#include "color/luminance.h"
#include "color/sensor.h"

namespace eikonal {

void expose(FilmImage& image, const FilmDescription& film) {
    const SensorDescription sensor{film.sensor, film.whiteBalance, film.exposureTime * film.iso / 100, film.colorSpace};
    const bool isPlain = sensor.name == "cie1931" && sensor.whiteBalance == 0 && sensor.imagingRatio == 1;
    if (isPlain) return;  // keeps all bits, in any colour space

    const glm::dmat3 matrix = rgbFromXyz(ColorSpace::srgb) * xyzFromRgb(sensor.output) * pixelFromLinearSrgb(sensor);
    for (std::size_t i = 0; i < image.color.size(); ++i) {
        const glm::dvec3 before = image.color[i], after = matrix * before;
        image.color[i] = glm::vec3(after);
        if (image.variance.empty()) continue;
        const double ratio = luminance(before) > 0 ? luminance(after) / luminance(before) : luminance(matrix * glm::dvec3(1));
        image.variance[i] *= static_cast<float>(ratio * ratio);
    }
}

FilmImage developExposed(const FilmTotals& totals, const PackedScene& scene, const FilmDescription& film) {
    FilmImage image = totals.develop(scene);
    if (!scene.features.has(Feature::SPECTRAL)) expose(image, film);
    return image;
}

}  // namespace eikonal
