// Spectra and their colours, against published values and against the physics they stand for.

#include "color/sensor.h"
#include "color/spectrum.h"
#include "color/uplift.h"
#include "color/uplift_table.h"
#include "eikonal/scene.h"

#include <gmock/gmock.h>

#include <complex>

namespace eikonal {
namespace {

Spectrum named(const std::string& name) { return Spectrum::sampled(namedSpectrum(name)); }

glm::dvec2 chromaticity(glm::dvec3 linearSrgb) {
    const glm::dvec3 xyz = xyzFromRgb(ColorSpace::srgb) * linearSrgb;
    return glm::dvec2(xyz) / (xyz.x + xyz.y + xyz.z);
}

double luminance(glm::dvec3 linearSrgb) { return (xyzFromRgb(ColorSpace::srgb) * linearSrgb).y; }

void expectNear(glm::dvec3 a, glm::dvec3 b, double tolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "channel " << i;
}

TEST(SampledCurve, IsLinearBetweenItsSamplesAndZeroBeyond) {
    const SampledCurve curve{{400, 500, 700}, {1, 3, 0}};
    EXPECT_EQ(curve(400), 1);
    EXPECT_EQ(curve(450), 2);
    EXPECT_EQ(curve(600), 1.5);
    EXPECT_EQ(curve(700), 0);
    EXPECT_EQ(curve(399.9), 0);
    EXPECT_EQ(curve(700.1), 0);
    EXPECT_EQ(SampledCurve{}(500), 0);
}

TEST(NamedSpectrum, HasEveryNameOfPbrt) {
    for (const char* name : {"glass-BK7", "glass-BAF10", "glass-FK51A", "glass-LASF9", "glass-F5", "glass-F10", "glass-F11", "metal-Ag-eta",
                             "metal-Ag-k", "metal-Al-eta", "metal-Au-k", "metal-Cu-eta", "metal-CuZn-k", "metal-MgO-eta", "metal-TiO2-k",
                             "stdillum-A", "stdillum-D50", "stdillum-D65", "stdillum-F1", "stdillum-F12", "illum-acesD60",
                             "canon_eos_100d_r", "sony_ilce_9_b", "nikon_d850_g", "hasselblad_l1d_20c_r"})
        EXPECT_TRUE(namedSpectrum(name)) << name;
    EXPECT_FALSE(namedSpectrum("metal-Unobtainium-eta"));
    EXPECT_THAT(spectrumNames(), testing::Contains("metal-Cu-eta"));
    EXPECT_TRUE(std::ranges::is_sorted(spectrumNames()));
}

TEST(NamedSpectrum, HoldsTheMeasurementAndExtendsItOverTheVisibleRange) {
    EXPECT_EQ((*namedSpectrum("metal-Cu-eta"))(302.4), 1.38);
    EXPECT_GT((*namedSpectrum("canon_eos_100d_r"))(360), 0);
    EXPECT_GT((*namedSpectrum("swatch-00"))(830), 0);
}

// IEC 61966-2-1 gives the matrix to four digits.
TEST(ColorSpace, OfSrgbIsThatOfItsStandard) {
    const glm::dmat3 published(.4124, .2126, .0193, .3576, .7152, .1192, .1805, .0722, .9505);
    for (int i = 0; i < 3; ++i) expectNear(xyzFromRgb(ColorSpace::srgb)[i], published[i], 2e-4);
}

TEST(ColorSpace, IsFoundByNameInAnyCase) {
    EXPECT_EQ(colorSpaceNamed("sRGB"), ColorSpace::srgb);
    EXPECT_EQ(colorSpaceNamed("dci-p3"), ColorSpace::dciP3);
    EXPECT_EQ(colorSpaceNamed("Rec2020"), ColorSpace::rec2020);
    EXPECT_EQ(colorSpaceNamed("aces2065-1"), ColorSpace::aces2065);
    EXPECT_FALSE(colorSpaceNamed("adobe"));
}

TEST(ColorSpace, WhiteIsItsWhite) {
    for (const std::string& name : colorSpaceNames()) {
        const ColorSpace space = *colorSpaceNamed(name);
        const glm::dvec3 white = xyzFromRgb(space) * glm::dvec3(1);
        EXPECT_NEAR(white.y, 1, 1e-12);
        EXPECT_NEAR(white.x / (white.x + white.y + white.z), whitePoint(space).x, 1e-12);
    }
    EXPECT_NEAR(whitePoint(ColorSpace::srgb).x, 0.3127, 1e-4);
    EXPECT_NEAR(whitePoint(ColorSpace::srgb).y, 0.3290, 1e-4);
    EXPECT_NEAR(whitePoint(ColorSpace::aces2065).x, 0.32168, 1e-4);
}

TEST(Spectrum, RgbPassesThrough) {
    const Spectrum s = Spectrum::rgb({.2, 5, .7});
    EXPECT_EQ(s.albedo(), glm::dvec3(.2, 5, .7));
    EXPECT_EQ(s.illuminant(), glm::dvec3(.2, 5, .7));
    EXPECT_EQ((s * 2).illuminant(), glm::dvec3(.4, 10, 1.4));
    EXPECT_EQ(Spectrum::constant(.5).albedo(), glm::dvec3(.5));
    EXPECT_EQ(Spectrum::constant(.5).value(), .5);
    EXPECT_EQ(Spectrum().albedo(), glm::dvec3(0));
    EXPECT_TRUE(Spectrum::constant(1).isConstant());
    EXPECT_FALSE(s.isConstant());
}

// White is white under any light, and half of it is grey.
TEST(Spectrum, AlbedoOfAFlatCurveIsGrey) {
    expectNear(Spectrum::sampled({{300, 900}, {.5, .5}}).albedo(), glm::dvec3(.5), 1e-12);
    expectNear((Spectrum::sampled({{300, 900}, {.5, .5}}) * 2).albedo(), glm::dvec3(1), 1e-12);
    EXPECT_NEAR(Spectrum::sampled({{300, 900}, {1.5, 1.5}}).value(), 1.5, 1e-12);
}

// A curve that only reflects below 480 nm is outside of sRGB (its red and green are negative there); no coefficient may be.
TEST(Spectrum, AlbedoIsNeverNegative) {
    const glm::dvec3 violet = Spectrum::sampled({{400, 420, 430, 450}, {0, 1, 1, 0}}).albedo();
    EXPECT_GE(std::min({violet.x, violet.y, violet.z}), 0);
    EXPECT_GT(violet.z, 0.1);
}

TEST(Spectrum, LightsHaveLuminanceOne) {
    expectNear(named("stdillum-D65").illuminant(), glm::dvec3(1), 1e-9);
    for (const Spectrum& s : {named("stdillum-A"), named("stdillum-F2"), Spectrum::blackbody(1500), Spectrum::blackbody(12000),
                              Spectrum::sampled({{500, 550, 600}, {0, 1e-7, 0}})}) {
        EXPECT_NEAR(luminance(s.illuminant()), 1, 1e-12);
        EXPECT_NEAR(luminance((s * 3).illuminant()), 3, 1e-12);
    }
    EXPECT_EQ(Spectrum::sampled({{500, 600}, {0, 0}}).illuminant(), glm::dvec3(0));
}

// CIE standard illuminant A is a black body of 2856 K; its chromaticity is (0.44757, 0.40745).
TEST(Spectrum, BlackbodyHasTheChromaticityOfItsTemperature) {
    EXPECT_NEAR(chromaticity(Spectrum::blackbody(2856).illuminant()).x, 0.44757, 3e-4);
    EXPECT_NEAR(chromaticity(Spectrum::blackbody(2856).illuminant()).y, 0.40745, 3e-4);
    const DenseCurve curve = Spectrum::blackbody(5000).dense();
    EXPECT_NEAR(*std::ranges::max_element(curve), 1, 1e-5);
    EXPECT_EQ(360 + (std::ranges::max_element(curve) - curve.begin()), 580);  // Wien: 2.8978e6 / 5000 = 579.6 nm
}

// The sodium D line: 1.5168 is what Schott gives for BK7.
TEST(Spectrum, ValueOfAGlassIsItsIndexWhereTheEyeIsMostSensitive) { EXPECT_NEAR(named("glass-BK7").value(), 1.5168, 2e-3); }

// A colour of a wider space with the same white is the same light; its coordinates follow from the matrices.
TEST(Spectrum, ColorsOfOtherSpacesMoveToSrgb) {
    const glm::dvec3 moved = Spectrum::rgb({.5, .5, .6}, ColorSpace::rec2020).illuminant();
    expectNear(rgbFromXyz(ColorSpace::rec2020) * (xyzFromRgb(ColorSpace::srgb) * moved), {.5, .5, .6}, 1e-12);
    expectNear(Spectrum::rgb({.5, .5, .6}, ColorSpace::rec2020).albedo(), moved, 1e-12);
    expectNear(Spectrum::rgb({.4, .4, .4}, ColorSpace::aces2065).albedo(), glm::dvec3(.4), 1e-12);
    EXPECT_GT(Spectrum::rgb({1, 1, 1}, ColorSpace::aces2065).illuminant().x, 1.03);  // its white is redder than D65
}

TEST(Uplift, GivesACurveOfTheColor) {
    const DenseCurve& white = whiteSpectrum(ColorSpace::srgb);
    for (const glm::dvec3& color :
         {glm::dvec3(.5, .5, .5), {.9, .1, .1}, {.05, .6, .02}, {.1, .2, .95}, {.98, .97, .02}, {.02, .02, .03}}) {
        const SmoothReflectance smooth = upliftReflectance(color, ColorSpace::srgb);
        DenseCurve reflected;
        for (int i = 0; i < wavelengthCount; ++i) {
            const double reflectance = smooth(shortestWavelength + i);
            EXPECT_GE(reflectance, 0);
            EXPECT_LE(reflectance, 1);
            reflected[i] = reflectance * white[i];
        }
        expectNear(rgbFromXyz(ColorSpace::srgb) * integrateXyz(reflected) / integrateXyz(white).y, color, 1e-4);
    }
}

/// The colour that a smooth reflectance has under daylight.
glm::dvec3 colorOf(const SmoothReflectance& smooth) {
    const DenseCurve& white = whiteSpectrum(ColorSpace::srgb);
    DenseCurve reflected;
    for (int i = 0; i < wavelengthCount; ++i) reflected[i] = smooth(shortestWavelength + i) * white[i];
    return rgbFromXyz(ColorSpace::srgb) * integrateXyz(reflected) / integrateXyz(white).y;
}

// The program carries the table that is fitted.
TEST(UpliftTable, IsTheOneThatIsFitted) {
    const std::vector<float> fitted = fitUpliftTable();
    EXPECT_THAT(fitted, testing::ElementsAreArray(upliftTable()));
}

// What an image's texels go through. Colours between the table's nodes; worst where all but one channel vanish.
TEST(UpliftTable, GivesACurveOfTheColor) {
    double sum = 0, count = 0;
    for (double r = 0.03; r < 1; r += 0.12)
        for (double g = 0.02; g < 1; g += 0.11)
            for (double b = 0.04; b < 1; b += 0.13) {
                const glm::dvec3 color(r, g, b), error = colorOf(tabulatedReflectance(color)) - color;
                const double worst = std::max({std::abs(error.x), std::abs(error.y), std::abs(error.z)});
                EXPECT_LT(worst, 0.008) << r << " " << g << " " << b;
                sum += worst;
                ++count;
            }
    EXPECT_LT(sum / count, 0.0015);
    expectNear(colorOf(tabulatedReflectance(glm::dvec3(.3))), glm::dvec3(.3), 1e-9);
    expectNear(colorOf(tabulatedReflectance({0, 0, 0})), glm::dvec3(0), 1e-3);
}

// Daylight is white to the plain film; balanced to its own colour, to any; a sensor of a camera that is balanced to it sees it as white,
// too.
TEST(Sensor, SeesTheLightThatItIsBalancedToAsWhite) {
    const auto seen = [](const SensorDescription& sensor, const Spectrum& light) {
        const auto response = linearSrgbResponse(sensor);
        const DenseCurve curve = light.dense();
        glm::dvec3 sum(0);
        for (int i = 0; i < wavelengthCount; ++i) sum += response[i] * curve[i];
        return sum / integrateXyz(curve).y;
    };
    expectNear(seen({}, named("stdillum-D65")), glm::dvec3(1), 1e-9);
    expectNear(seen({.imagingRatio = 2.5}, named("stdillum-D65")), glm::dvec3(2.5), 1e-9);
    expectNear(seen({.whiteBalance = 6500}, named("stdillum-D65")), glm::dvec3(1), 0.002);
    expectNear(seen({.name = "canon_eos_100d", .whiteBalance = 6500}, named("stdillum-D65")), glm::dvec3(1), 0.03);
}

TEST(Spectrum, DenseCurveOfAColorHasThatColor) {
    const Spectrum dense = Spectrum::sampled([] {
        SampledCurve curve;
        const DenseCurve values = Spectrum::rgb({3.9, 2.4, 2.1}).dense();
        for (int i = 0; i < wavelengthCount; ++i) {
            curve.wavelengths.push_back(shortestWavelength + i);
            curve.values.push_back(values[i]);
        }
        return curve;
    }());
    expectNear(dense.albedo(), {3.9, 2.4, 2.1}, 1e-3);
}

double fresnel(double cosine, double eta, double k) {
    const std::complex<double> n(eta, k), t = std::sqrt(1.0 - (1 - cosine * cosine) / (n * n));
    return (std::norm((n * cosine - t) / (n * cosine + t)) + std::norm((cosine - n * t) / (cosine + n * t))) / 2;
}

/// Greatest difference over all angles between the three indices and daylight's colour after the spectral reflection.
glm::dvec3 greatestError(const std::string& metal) {
    const Spectrum eta = named("metal-" + metal + "-eta"), k = named("metal-" + metal + "-k");
    const ConductorIndices indices = conductorIndices(eta, k);
    const DenseCurve etas = eta.dense(), ks = k.dense(), white = whiteSpectrum(ColorSpace::srgb);
    glm::dvec3 greatest(0);
    for (double cosine = 0; cosine <= 1; cosine += 0.01) {
        DenseCurve reflected;
        for (int i = 0; i < wavelengthCount; ++i) reflected[i] = white[i] * fresnel(cosine, etas[i], ks[i]);
        const glm::dvec3 color = rgbFromXyz(ColorSpace::srgb) * integrateXyz(reflected) / integrateXyz(white).y;
        for (int c = 0; c < 3; ++c)
            greatest[c] = std::max(greatest[c], std::abs(color[c] - fresnel(cosine, indices.eta[c], indices.k[c])));
    }
    return greatest;
}

TEST(ConductorIndices, ReflectLikeTheMetalAtEveryAngle) {
    for (const char* metal : {"Ag", "Al", "Cu", "CuZn", "MgO", "TiO2"}) {
        const glm::dvec3 error = greatestError(metal);
        EXPECT_LT(std::max({error.x, error.y, error.z}), 0.005) << metal;
    }
}

// Gold is more orange than any surface of sRGB can be: its red is 1.022 at normal incidence, and no surface reflects more than 1.
TEST(ConductorIndices, OfGoldAreAsNearAsASurfaceCanBe) {
    const glm::dvec3 error = greatestError("Au");
    EXPECT_LT(error.x, 0.026);
    EXPECT_LT(error.y, 0.005);
    EXPECT_LT(error.z, 0.005);
}

TEST(ConductorIndices, OfConstantsAreThemselves) {
    const ConductorIndices indices = conductorIndices(Spectrum::constant(.2), Spectrum::constant(4));
    EXPECT_EQ(indices.eta, glm::dvec3(.2));
    EXPECT_EQ(indices.k, glm::dvec3(4));
    const ConductorIndices grey = conductorIndices(Spectrum::rgb(glm::dvec3(1.0001)), Spectrum::sampled({{300, 900}, {1e-4, 1e-4}}));
    EXPECT_EQ(grey.eta, glm::dvec3(1.0001));
    expectNear(grey.k, glm::dvec3(1e-4), 1e-15);
}

// Colours near grey stay nearly themselves, since their smooth spectra are nearly flat.
TEST(ConductorIndices, OfRgbAreNearThatRgb) {
    const ConductorIndices indices = conductorIndices(Spectrum::rgb({1.1, 1.0, .9}), Spectrum::rgb({3, 3, 3}));
    expectNear(indices.eta, {1.1, 1.0, .9}, 0.02);
    expectNear(indices.k, {3, 3, 3}, 0.02);
}

TEST(Sensor, DefaultChangesNothing) {
    EXPECT_EQ(imageFromLight({}), glm::dmat3(1));
    EXPECT_EQ(imageFromLight({.imagingRatio = 2}), glm::dmat3(2));
    EXPECT_EQ(imageFromLight({.output = ColorSpace::aces2065}), glm::dmat3(1));
}

// CIE 15 gives the chromaticity of D50 as (0.34567, 0.35850).
TEST(Sensor, WhiteBalanceMakesItsDaylightWhite) {
    const glm::dvec3 d50 = rgbFromXyz(ColorSpace::srgb) * glm::dvec3(.34567, .35850, 1 - .34567 - .35850) / .35850;
    for (const ColorSpace space : {ColorSpace::srgb, ColorSpace::rec2020})   // both with a white of D65
        expectNear(imageFromLight({.whiteBalance = 5000, .output = space}) * d50, glm::dvec3(1), 1e-3);
}

// CIE daylight begins at 4000 K: lamps are balanced as black bodies. Of 3200 K: what 3200 * 1.4388 / 1.4380 = 3201.8 K shines.
TEST(Sensor, WhiteBalanceOfALampMakesABlackBodyWhite) {
    for (const double kelvin : {2000., 3200.}) {
        const glm::dvec3 lamp = Spectrum::blackbody(kelvin * 1.4388 / 1.4380).illuminant();
        expectNear(imageFromLight({.whiteBalance = kelvin}) * lamp, glm::dvec3(1), 1e-6);
    }
    /* Blue skies go on beyond 25000 K: at 50000 K * 1.4388 / 1.4380, x is 0.24273 and y 0.24488 by CIE 15's polynomials */
    const glm::dvec3 sky = rgbFromXyz(ColorSpace::srgb) * glm::dvec3(.242731, .244883, 1 - .242731 - .244883) / .244883;
    expectNear(imageFromLight({.whiteBalance = 50000}) * sky, glm::dvec3(1), 2e-3);
}

// A camera balanced for D65 sees the chart under D65 as it is, but for the errors of its own fit.
TEST(Sensor, CamerasSeeDaylightAsTheEyeDoes) {
    EXPECT_EQ(sensorNames().size(), 18u);
    for (const std::string& name : sensorNames()) {
        const glm::dmat3 m = imageFromLight({.name = name, .whiteBalance = name == "cie1931" ? 0 : 6500.});
        expectNear(m * glm::dvec3(.5), glm::dvec3(.5), 0.02);
    }
}

}  // namespace
}  // namespace eikonal
