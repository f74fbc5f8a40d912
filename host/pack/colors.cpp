#include "pack/colors.h"

#include "color/luminance.h"
#include "color/transfer.h"
#include "pack/packer.h"
#include "color/sensor.h"
#include "color/uplift_table.h"

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

float toFloat(double x) { return static_cast<float>(x); }

/// Far enough along the sigmoid for it to be 1: a color that is its curve alone.
constexpr float saturated = 1e6f;

/// The index of a curve in `curves`, which begins with that of 1.
uint packCurve(Packer& packer, const DenseCurve& curve) {
    const auto [found, isNew] =
        packer.colors.curves.try_emplace(curve, static_cast<uint>(packer.packed.tables.curves.size() / CURVE_WORDS));
    if (isNew)
        for (double value : curve) packer.packed.tables.curves.push_back(toFloat(value));
    return found->second;
}

color packCurveColor(Packer& packer, const DenseCurve& curve, double factor) {
    return {0, 0, saturated, toFloat(factor), packCurve(packer, curve)};
}

/// A smooth spectrum of a colour whose components are in [0, 1], times `factor`, times a curve.
color packSmooth(Packer& packer, glm::dvec3 rgb, ColorSpace space, double factor, uint curve) {
    if (rgb.x == rgb.y && rgb.y == rgb.z) return {0, 0, saturated, toFloat(rgb.x * factor), curve};
    /* A few colours exactly; many, as grids have them, from the table, which is faster */
    constexpr size_t few = 256;
    const auto [found, isNew] = packer.colors.smooth.try_emplace({rgb.x, rgb.y, rgb.z, space});
    if (isNew)
        found->second =
            space == ColorSpace::srgb && packer.colors.smooth.size() > few ? tabulatedReflectance(rgb) : upliftReflectance(rgb, space);
    const glm::dvec3 c = found->second.c;
    return {toFloat(c.x), toFloat(c.y), toFloat(c.z), toFloat(factor), curve};
}

/// The same of any colour that is not negative: scaled to the middle of the sigmoid's range, as pbrt-v4's unbounded spectra are.
color packUnbounded(Packer& packer, glm::dvec3 rgb, ColorSpace space, double factor, uint curve) {
    rgb = glm::max(rgb, 0.0);
    const double scale = 2 * std::max({rgb.x, rgb.y, rgb.z});
    if (!(scale > 0)) return {0, 0, saturated, 0, curve};
    return packSmooth(packer, rgb / scale, space, scale * factor, curve);
}

/// A curve whose light has luminance 1; one that is 0 stays so.
DenseCurve ofUnitLuminance(DenseCurve curve) {
    const double luminance = integrateXyz(curve).y;
    if (luminance > 0)
        for (double& value : curve) value /= luminance;
    return curve;
}

DenseCurve constantCurve(double value) { DenseCurve curve; curve.fill(value); return curve; }

/// Three curves: what each channel is given by light of each wavelength. Returns the index of the first.
uint packResponse(Packer& packer, const std::array<glm::dvec3, wavelengthCount>& response) {
    Table<float>& curves = packer.packed.tables.curves;
    const uint first = static_cast<uint>(curves.size() / CURVE_WORDS);
    for (int channel = 0; channel < 3; ++channel)
        for (const glm::dvec3& r : response) curves.push_back(toFloat(r[channel]));
    return first;
}

}  // namespace

color packRgb(glm::dvec3 rgb) { return {toFloat(rgb.x), toFloat(rgb.y), toFloat(rgb.z), 1, 0}; }

color packNumber(double value) { return {0, 0, 0, toFloat(value), 0}; }

color packConstant(Packer& packer, double value) {
    if (packer.spectral) return {0, 0, saturated, toFloat(value), 0};
    color c = packRgb(glm::dvec3(value));
    c.scale = toFloat(value);
    return c;
}

color packEmission(Packer& packer, const Spectrum& light, double factor) {
    if (!packer.spectral) return packRgb(light.illuminant() * factor);
    if (light.kind() != Spectrum::Kind::rgb) return packCurveColor(packer, ofUnitLuminance(light.dense()), light.factor() * factor);
    return packUnbounded(packer, light.color(), light.space(), factor, packCurve(packer, ofUnitLuminance(whiteSpectrum(light.space()))));
}

color packReflectance(Packer& packer, const Spectrum& reflectance) {
    const glm::dvec3 rgb = reflectance.color();
    const bool isAlbedo = reflectance.kind() == Spectrum::Kind::rgb && std::max({rgb.x, rgb.y, rgb.z}) <= 1;
    if (!packer.spectral || reflectance.isConstant() || !isAlbedo) return packCoefficient(packer, reflectance);
    return packSmooth(packer, glm::max(rgb, 0.0), reflectance.space(), 1, 0);
}

color packCoefficient(Packer& packer, const Spectrum& coefficient, double factor) {
    if (coefficient.isConstant()) return packConstant(packer, coefficient.value() * factor);
    if (!packer.spectral) return packRgb(coefficient.albedo() * factor);
    if (coefficient.kind() != Spectrum::Kind::rgb) return packCurveColor(packer, coefficient.dense(), factor);
    return packUnbounded(packer, coefficient.color(), coefficient.space(), factor, 0);
}

float greatestSum(const Packer& packer, const color* a, const color* b) {
    static const color nothing{};
    const color &p = a ? *a : nothing, &q = b ? *b : nothing;
    if (!packer.spectral) return std::max({p.c0 + q.c0, p.c1 + q.c1, p.c2 + q.c2});
    const auto bound = [&](const color& c) {
        /* The quadratic is greatest at an end or at its vertex, the sigmoid with it; the curve is that of 1, or bounded by its own greatest
         * value */
        const auto at = [&](double t) { return (c.c0 * t + c.c1) * t + c.c2; };
        double x = std::max(at(0), at(1));
        if (c.c0 < 0) x = std::max(x, at(std::clamp(-c.c1 / (2.0 * c.c0), 0.0, 1.0)));
        const auto curve = packer.packed.tables.curves.begin() + static_cast<long>(c.curve) * CURVE_WORDS;
        return c.scale * *std::max_element(curve, curve + CURVE_WORDS) * (0.5 + 0.5 * x / std::sqrt(1 + x * x)) * (1 + 1e-5);
    };
    return toFloat(bound(p) + bound(q));
}

color packWhite(Packer& packer, double factor) { return packEmission(packer, Spectrum::rgb(glm::dvec3(1)), factor); }

void packTexels(Packer& packer, const std::vector<glm::vec3>& texels) {
    Table<float>& table = packer.packed.tables.environment_texels;
    for (const glm::vec3& t : texels) {
        if (!packer.spectral) { table.insert(table.end(), {t.x, t.y, t.z}); continue; }
        if (t.x == t.y && t.y == t.z) { table.insert(table.end(), {0, 0, saturated, t.x}); continue; }
        const float scale = 2 * std::max({t.x, t.y, t.z});
        const glm::vec3 c(tabulatedReflectance(glm::dvec3(t) / double(scale)).c);
        table.insert(table.end(), {c.x, c.y, c.z, scale});
    }
}

void packUplift(Packer& packer) {
    if (packer.packed.tables.uplift.empty()) packer.packed.tables.uplift.assign(upliftTable().begin(), upliftTable().end());
}

void packSensor(Packer& packer) {
    packCurve(packer, constantCurve(1));
    settings& frame = packer.packed.frame();
    const FilmDescription& film = packer.scene.film;
    frame.sensor_curves =
        packResponse(packer, linearSrgbResponse({film.sensor, film.whiteBalance, film.exposureTime * film.iso / 100, film.colorSpace}));
    const DenseCurve white = ofUnitLuminance(whiteSpectrum(ColorSpace::srgb));
    auto albedo = matchingFunctions();
    for (int i = 0; i < wavelengthCount; ++i) albedo[i] = rgbFromXyz(ColorSpace::srgb) * albedo[i] * white[i];
    frame.albedo_curves = packResponse(packer, albedo);
}

double luminanceOf(const Spectrum& light, double factor) {
    return luminance(glm::vec3(light.illuminant() * factor));
}

Table<float> srgbLevels() {
    Table<float> levels;
    for (int level = 0; level < 256; ++level) levels.push_back(static_cast<float>(linearFromSrgb(level / 255.0)));
    return levels;
}

}  // namespace eikonal
