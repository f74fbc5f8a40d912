// The responses of film and auxiliary channels to wavelengths, and the range of a film that stores spectra.

#include "color/sensor.h"
#include "pack/colors.h"
#include "pack/space.h"

#include <algorithm>

namespace eikonal {

static float toFloat(double x) { return static_cast<float>(x); }

/// Adds three curves: the response of each channel to light of each wavelength. Returns the index of the first.
uint ColorPacker::response(const std::array<glm::dvec3, wavelengthCount>& response) {
    const uint first = static_cast<uint>(tables_.curves.size() / CURVE_WORDS);
    for (int channel = 0; channel < 3; ++channel)
        for (const glm::dvec3& r : response) tables_.curves.push_back(toFloat(r[channel]));
    return first;
}

static SensorDescription sensorOf(const FilmDescription& film) {
    return {film.sensor, film.whiteBalance, film.exposureTime * film.iso / 100, film.colorSpace};
}

void packExposure(const FilmDescription& film, settings& frame) {
    frame.image_from_light = toAffine(glm::dmat4(imageFromLight(sensorOf(film))));
    frame.max_component_value = toFloat(film.maxComponentValue);
}

void ColorPacker::packSensor(settings& frame) {
    DenseCurve one;
    one.fill(1);
    curve(one);
    frame.sensor_curves = response(linearSrgbResponse(sensorOf(context_.scene.film)));
    const DenseCurve white = ofUnitLuminance(whiteSpectrum(ColorSpace::srgb));
    auto albedo = matchingFunctions();
    for (int i = 0; i < wavelengthCount; ++i) albedo[i] = rgbFromXyz(ColorSpace::srgb) * albedo[i] * white[i];
    frame.albedo_curves = response(albedo);
}

/// At least this fraction of the wavelengths is sampled in the film's range. The others, one of a path's four, complete the pixels'
/// colours.
constexpr double leastShare = 0.75;

void ColorPacker::packFilmSpectrum(settings& frame) {
    const FilmDescription& film = context_.scene.film;
    if (!film.spectrum) return;
    context_.require(Feature::SPECTRAL_FILM, film.where.toString());
    frame.bucket_count = static_cast<uint>(film.spectrum->buckets);

    /* Uniform over everything visible, unless too few of them would fall into the range */
    const double all = longestWavelength - shortestWavelength, extent = film.spectrum->last - film.spectrum->first;
    const double share = std::max(extent / all, leastShare), inversePdf = extent / share;
    const double beside = share < 1 ? (all - extent) / (1 - share) : inversePdf;
    tables_.wavelengths.push_back(
        {toFloat(film.spectrum->first), toFloat(extent), toFloat(share), toFloat(inversePdf), toFloat(beside), 0, 0});
}

void ColorPacker::packPassWavelengths(const settings& frame) {
    /* Where pixels share a sequence, the pass is in the lower bits of an index (place_in_sequence) */
    const uint mask = frame.sequence_tile_bits ? (1u << frame.sequence_sample_bits) - 1 : ~0u;
    tables_.wavelengths.push_back({.pass_mask = mask, .pass_seed = frame.seed});
}

}  // namespace eikonal
