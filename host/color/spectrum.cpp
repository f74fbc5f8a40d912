#include "color/spectrum.h"

#include "color/uplift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace eikonal {
namespace {

/// Spectral radiance of a black body, W / (m^2 sr m), by Planck's law.
double planck(double nanometers, double kelvin) {
    constexpr double c = 299792458, h = 6.62607015e-34, k = 1.380649e-23;
    const double l = nanometers * 1e-9;
    return 2 * h * c * c / (std::pow(l, 5) * std::expm1(h * c / (l * k * kelvin)));
}

DenseCurve blackbodyCurve(double kelvin) {
    DenseCurve curve{};
    if (!(kelvin > 0)) return curve;
    constexpr double wien = 2.897771955e6;  // Wien's displacement constant, nm K
    const double maximum = planck(wien / kelvin, kelvin);
    for (int i = 0; i < wavelengthCount; ++i) curve[i] = planck(shortestWavelength + i, kelvin) / maximum;
    return curve;
}

/// XYZ of daylight (D65) reflected with this reflectance; Y = 1 for perfect white.
glm::dvec3 xyzUnderDaylight(const DenseCurve& reflectance) {
    const DenseCurve& white = whiteSpectrum(ColorSpace::srgb);
    DenseCurve reflected;
    for (int i = 0; i < wavelengthCount; ++i) reflected[i] = reflectance[i] * white[i];
    return integrateXyz(reflected) / integrateXyz(white).y;
}

}  // namespace

Spectrum Spectrum::constant(double value) {
    Spectrum s;
    s.rgb_ = glm::dvec3(value);
    return s;
}

Spectrum Spectrum::rgb(glm::dvec3 color, ColorSpace space) {
    Spectrum s;
    s.constant_ = false;
    s.rgb_ = color;
    s.space_ = space;
    return s;
}

Spectrum Spectrum::sampled(SampledCurve curve) { return sampled(std::make_shared<const SampledCurve>(std::move(curve))); }

Spectrum Spectrum::sampled(const DenseCurve& dense) {
    SampledCurve curve;
    for (const double value : dense) {
        curve.wavelengths.push_back(shortestWavelength + static_cast<double>(curve.wavelengths.size()));
        curve.values.push_back(value);
    }
    return sampled(std::move(curve));
}
Spectrum Spectrum::sampled(std::shared_ptr<const SampledCurve> curve) {
    Spectrum s;
    s.kind_ = Kind::sampled;
    s.constant_ = false;
    s.curve_ = std::move(curve);
    return s;
}

Spectrum Spectrum::blackbody(double kelvin) {
    Spectrum s;
    s.kind_ = Kind::blackbody;
    s.constant_ = false;
    s.kelvin_ = kelvin;
    return s;
}

DenseCurve Spectrum::dense() const {
    DenseCurve curve{};
    if (kind_ == Kind::rgb) {
        const double largest = std::max({rgb_.x, rgb_.y, rgb_.z});
        if (constant_ || (rgb_.x == rgb_.y && rgb_.y == rgb_.z)) {
            curve.fill(rgb_.x);
        } else if (largest > 0) {
            const double scale = 2 * largest;  // so the largest component is in the middle of the sigmoid's range
            const SmoothReflectance smooth = upliftReflectance(rgb_ / scale, space_);
            for (int i = 0; i < wavelengthCount; ++i) curve[i] = scale * smooth(shortestWavelength + i);
        }
        return curve;
    }
    curve = kind_ == Kind::sampled ? densify(*curve_) : blackbodyCurve(kelvin_);
    for (double& value : curve) value *= factor_;
    return curve;
}

glm::dvec3 Spectrum::albedo() const {
    const bool grey = rgb_.x == rgb_.y && rgb_.y == rgb_.z;
    if (kind_ == Kind::rgb && (space_ == ColorSpace::srgb || grey)) return rgb_;
    if (kind_ == Kind::rgb && whitePoint(space_) == whitePoint(ColorSpace::srgb)) return glm::max(illuminant(), 0.0);
    return glm::max(rgbFromXyz(ColorSpace::srgb) * xyzUnderDaylight(dense()), 0.0);
}

glm::dvec3 Spectrum::illuminant() const {
    if (kind_ == Kind::rgb && space_ == ColorSpace::srgb) return rgb_;
    if (kind_ == Kind::rgb) return rgbFromXyz(ColorSpace::srgb) * (xyzFromRgb(space_) * rgb_);
    const glm::dvec3 xyz = integrateXyz(kind_ == Kind::sampled ? densify(*curve_) : blackbodyCurve(kelvin_));
    return xyz.y > 0 ? rgbFromXyz(ColorSpace::srgb) * xyz / xyz.y * factor_ : glm::dvec3(0);
}

bool Spectrum::isFlat() const { return kind_ == Kind::rgb && rgb_.x == rgb_.y && rgb_.y == rgb_.z; }
double Spectrum::value() const { return isFlat() ? rgb_.x : xyzUnderDaylight(dense()).y; }

/// Whether all of them are in [0, 1].
static bool isInUnit(std::span<const double> values) {
    return std::ranges::all_of(values, [](double value) { return value >= 0 && value <= 1; });
}
static bool isInUnit(const glm::dvec3& rgb) { return isInUnit(std::array{rgb.x, rgb.y, rgb.z}); }
/// The same of a colour in its space, or of the values at all wavelengths.
static bool isInUnit(const Spectrum& s) { return s.kind() == Spectrum::Kind::rgb ? isInUnit(s.color()) : isInUnit(s.dense()); }

bool Spectrum::isReflectance() const { return isInUnit(*this) && isInUnit(albedo()); }

Spectrum Spectrum::clampedToUnit() const {
    if (constant_) return constant(std::clamp(rgb_.x, 0.0, 1.0));
    if (isInUnit(*this)) return *this;
    DenseCurve values = dense();
    for (double& value : values) value = std::clamp(value, 0.0, 1.0);
    return sampled(values);
}

Spectrum Spectrum::operator*(double factor) const {
    Spectrum s = *this;
    s.rgb_ *= factor;
    s.factor_ *= factor;
    return s;
}

}  // namespace eikonal
