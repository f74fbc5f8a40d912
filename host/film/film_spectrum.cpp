#include "film/totals.h"
#include "eikonal/film.h"
#include "color/observer.h"

#include <tbb/parallel_for.h>

namespace eikonal {

/// Scale of a pixel's spectrum: the photometric integral of light that is 1 at every wavelength. ColorPacker::emission divides lights by
/// it, and this multiplies again, as pbrt-v4 does.
static double photometricIntegralOfOne() {
    DenseCurve one;
    one.fill(1);
    return integrateXyz(one).y;
}

void FilmTotals::developSpectrum(FilmImage& image, const PackedScene& scene) const {
    const wavelength_range& range = scene.tables.wavelengths.front();
    const size_t n = plane(), buckets = scene.frame().bucket_count;
    const double width = static_cast<double>(range.extent) / static_cast<double>(buckets);
    for (size_t b = 0; b < buckets; ++b) image.spectrum.wavelengths.push_back(range.first + (static_cast<double>(b) + 0.5) * width);

    /* Each wavelength of a sample represents 1 / density nm, of which the bucket covers `width` */
    const double scale = photometricIntegralOfOne() * static_cast<double>(range.inverse_pdf) / (CHANNELS_SPECTRAL * width);
    const float *sums = floats("buckets"), *weight = floats("weight");
    image.spectrum.radiance.resize(n * buckets);
    tbb::parallel_for(size_t(0), n, [&](size_t i) {
        for (size_t b = 0; b < buckets; ++b)
            image.spectrum.radiance[i * buckets + b] =
                weight[i] != 0 ? static_cast<float>(sums[b * BUCKET_WORDS * n + i] * scale / weight[i]) : 0;
    });
}

}  // namespace eikonal
