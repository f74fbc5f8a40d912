// What film and auxiliary channels make of wavelengths, and the spectrum that a film keeps.

#include "color/sensor.h"
#include "pack/colors.h"

#include <algorithm>

namespace eikonal {

static float toFloat(double x) { return static_cast<float>(x); }

/// Three curves: what light of each wavelength adds to each channel. Returns the index of the first.
uint ColorPacker::response(const std::array<glm::dvec3, wavelengthCount>& response) {
    const uint first = static_cast<uint>(tables_.curves.size() / CURVE_WORDS);
    for (int channel = 0; channel < 3; ++channel)
        for (const glm::dvec3& r : response) tables_.curves.push_back(toFloat(r[channel]));
    return first;
}

void ColorPacker::packSensor(settings& frame) {
    DenseCurve one;
    one.fill(1);
    curve(one);
    const FilmDescription& film = context_.scene.film;
    frame.sensor_curves =
        response(linearSrgbResponse({film.sensor, film.whiteBalance, film.exposureTime * film.iso / 100, film.colorSpace}));
    const DenseCurve white = ofUnitLuminance(whiteSpectrum(ColorSpace::srgb));
    auto albedo = matchingFunctions();
    for (int i = 0; i < wavelengthCount; ++i) albedo[i] = rgbFromXyz(ColorSpace::srgb) * albedo[i] * white[i];
    frame.albedo_curves = response(albedo);
}

/// The least part of the wavelengths that is within the film's range; the rest is outside it, and completes the pixels' colours. That is
/// one of a path's four wavelengths, then.
constexpr double leastShare = 0.75;

void ColorPacker::packFilmSpectrum(settings& frame) {
    const FilmDescription& film = context_.scene.film;
    if (!film.spectrum) return;
    context_.require(Feature::SPECTRAL_FILM, film.where.toString());
    frame.bucket_count = static_cast<uint>(film.spectrum->buckets);

    /* Uniform over everything visible, unless that leaves too few to the range */
    const double all = longestWavelength - shortestWavelength, extent = film.spectrum->last - film.spectrum->first;
    const double share = std::max(extent / all, leastShare), inversePdf = extent / share;
    const double beside = share < 1 ? (all - extent) / (1 - share) : inversePdf;
    tables_.wavelengths.push_back({toFloat(film.spectrum->first), toFloat(extent), toFloat(share), toFloat(inversePdf), toFloat(beside)});
}

}  // namespace eikonal
