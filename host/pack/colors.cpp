#include "pack/colors.h"

#include "color/luminance.h"
#include "color/uplift_table.h"

#include "error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

float toFloat(double x) { return static_cast<float>(x); }

/// Curves in all up to which smooth spectra become curves, too: the device reads them faster than it computes them, while its caches hold
/// them (120 KB).
constexpr size_t mostCurves = 64;

}  // namespace

/// The index of a curve in `curves`; adds it if it is new.
uint ColorPacker::curve(const DenseCurve& curve) {
    const auto [found, isNew] = curves_.try_emplace(curve, static_cast<uint>(tables_.curves.size() / CURVE_WORDS));
    if (isNew)
        for (double value : curve) tables_.curves.push_back(toFloat(value));
    return found->second;
}

color ColorPacker::curveColor(const DenseCurve& c, double factor) { return {0, 0, SATURATED, toFloat(factor), curve(c)}; }

/// A smooth spectrum of a colour whose components are in [0, 1], times `factor`, times a curve.
color ColorPacker::smooth(glm::dvec3 rgb, ColorSpace space, double factor, uint curve) {
    if (rgb.x == rgb.y && rgb.y == rgb.z) return {0, 0, SATURATED, toFloat(rgb.x * factor), curve};
    /* The first few colours are fitted exactly; many, as in grids, come from a table, which is faster */
    constexpr size_t few = 256;
    const auto [found, isNew] = smooth_.try_emplace({rgb.x, rgb.y, rgb.z, space});
    if (isNew)
        found->second = space == ColorSpace::srgb && smooth_.size() > few ? tabulatedReflectance(rgb) : upliftReflectance(rgb, space);
    if (const std::optional<uint> product = smoothCurve(found->second, curve)) return {0, 0, SATURATED, toFloat(factor), *product};
    const glm::dvec3 c = found->second.c;
    return {toFloat(c.x), toFloat(c.y), toFloat(c.z), toFloat(factor), curve};
}

std::optional<uint> ColorPacker::smoothCurve(const SmoothReflectance& shape, uint factor) {
    const auto key = std::tuple(shape.c.x, shape.c.y, shape.c.z, factor);
    if (const auto known = smoothCurves_.find(key); known != smoothCurves_.end()) return known->second;
    if (curves_.size() >= mostCurves) return std::nullopt;
    DenseCurve product;
    for (size_t i = 0; i < product.size(); ++i)
        product[i] = shape(SHORTEST_WAVELENGTH + static_cast<double>(i)) * tables_.curves[factor * CURVE_WORDS + i];
    return smoothCurves_[key] = this->curve(product);
}

/// The same for any non-negative colour: scaled to the middle of the sigmoid's range, like pbrt-v4's unbounded spectra.
color ColorPacker::unbounded(glm::dvec3 rgb, ColorSpace space, double factor, uint curve) {
    rgb = glm::max(rgb, 0.0);
    const double scale = 2 * std::max({rgb.x, rgb.y, rgb.z});
    if (!(scale > 0)) return {0, 0, SATURATED, 0, curve};
    return smooth(rgb / scale, space, scale * factor, curve);
}

DenseCurve ofUnitLuminance(DenseCurve curve) {
    const double luminance = integrateXyz(curve).y;
    if (luminance > 0)
        for (double& value : curve) value /= luminance;
    return curve;
}

color packRgb(glm::dvec3 rgb) { return {toFloat(rgb.x), toFloat(rgb.y), toFloat(rgb.z), 1, 0}; }

color packNumber(double value) { return {0, 0, 0, toFloat(value), 0}; }

color ColorPacker::constant(double value) const {
    if (context_.spectral) return {0, 0, SATURATED, toFloat(value), 0};
    color c = packRgb(glm::dvec3(value));
    c.scale = toFloat(value);
    return c;
}

color ColorPacker::emission(const Spectrum& light, double factor) {
    if (!context_.spectral) return packRgb(light.illuminant() * factor);
    if (light.kind() != Spectrum::Kind::rgb) return curveColor(ofUnitLuminance(light.dense()), light.factor() * factor);
    return unbounded(light.color(), light.space(), factor, curve(ofUnitLuminance(whiteSpectrum(light.space()))));
}

color ColorPacker::reflectance(const Spectrum& reflectance) {
    const Spectrum possible = reflectance.clampedToUnit();
    /* A saturated colour of a wider gamut has components above 1 in sRGB */
    if (!context_.spectral && !possible.isConstant()) return packRgb(glm::min(possible.albedo(), 1.0));
    return textureColor(possible);
}

color ColorPacker::textureColor(const Spectrum& color) {
    const glm::dvec3 rgb = color.color();
    const bool isAlbedo = color.kind() == Spectrum::Kind::rgb && std::max({rgb.x, rgb.y, rgb.z}) <= 1;
    if (!context_.spectral || color.isConstant() || !isAlbedo) return coefficient(color);
    return smooth(glm::max(rgb, 0.0), color.space(), 1, 0);
}

color ColorPacker::coefficient(const Spectrum& coefficient, double factor) {
    if (coefficient.isConstant()) return constant(coefficient.value() * factor);
    if (!context_.spectral) return packRgb(coefficient.albedo() * factor);
    if (coefficient.kind() != Spectrum::Kind::rgb) return curveColor(coefficient.dense(), factor);
    return unbounded(coefficient.color(), coefficient.space(), factor, 0);
}

float ColorPacker::greatestSum(const color* a, const color* b) const {
    static const color nothing{};
    const color &p = a ? *a : nothing, &q = b ? *b : nothing;
    if (!context_.spectral) return std::max({p.c0 + q.c0, p.c1 + q.c1, p.c2 + q.c2});
    const auto bound = [&](const color& c) {
        /* The quadratic has its maximum at an end or at its vertex, and so has the sigmoid; the curve is bounded by its maximum */
        const auto at = [&](double t) { return (c.c0 * t + c.c1) * t + c.c2; };
        double x = std::max(at(0), at(1));
        if (c.c0 < 0) x = std::max(x, at(std::clamp(-c.c1 / (2.0 * c.c0), 0.0, 1.0)));
        const auto curve = tables_.curves.begin() + static_cast<long>(c.curve) * CURVE_WORDS;
        return c.scale * *std::max_element(curve, curve + CURVE_WORDS) * (0.5 + 0.5 * x / std::sqrt(1 + x * x)) * (1 + 1e-5);
    };
    return toFloat(bound(p) + bound(q));
}

void ColorPacker::checkRange(const color& packed, const SourceLocation& where, const std::string& what) const {
    if (!std::isfinite(greatestSum(&packed, nullptr)))
        throw SceneError(where,
                         fmt::format("{} is too large: in the units of the scene, scaled to a size of about 1, it is beyond 3.4e38", what));
}

color ColorPacker::white(double factor) { return emission(Spectrum::rgb(glm::dvec3(1)), factor); }

void ColorPacker::appendTexels(Table<float>& table, const std::vector<glm::vec3>& texels) const {
    for (const glm::vec3& t : texels) {
        if (!context_.spectral) {
            table.insert(table.end(), {t.x, t.y, t.z});
            continue;
        }
        if (t.x == t.y && t.y == t.z) { table.insert(table.end(), {0, 0, SATURATED, t.x}); continue; }
        const float scale = 2 * std::max({t.x, t.y, t.z});
        const glm::vec3 c(tabulatedReflectance(glm::dvec3(t) / double(scale)).c);
        table.insert(table.end(), {c.x, c.y, c.z, scale});
    }
}

void ColorPacker::addUplift() {
    if (tables_.uplift.empty()) tables_.uplift.assign(upliftTable().begin(), upliftTable().end());
}

double luminanceOf(const Spectrum& light, double factor) {
    return luminance(glm::vec3(light.illuminant() * factor));
}

}  // namespace eikonal
