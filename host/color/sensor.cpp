#include "color/sensor.h"

#include "color/spectrum.h"

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

// Bradford cone responses, for white balance; columns.
const glm::dmat3 conesFromXyz(.8951, -.7502, .0389, .2664, 1.7135, -.0685, -.1614, .0367, 1.0296);

glm::dvec3 xyzOf(glm::dvec2 chromaticity) {
    return glm::dvec3(chromaticity.x, chromaticity.y, 1 - chromaticity.x - chromaticity.y) / chromaticity.y;
}

DenseCurve curveNamed(const std::string& name) { return densify(*namedSpectrum(name)); }

DenseCurve times(const DenseCurve& a, const DenseCurve& b) {
    DenseCurve product;
    for (int i = 0; i < wavelengthCount; ++i) product[i] = a[i] * b[i];
    return product;
}

double integral(const DenseCurve& curve) {
    double sum = 0;
    for (double value : curve) sum += value;
    return sum;
}

/// CIE daylight of a correlated colour temperature (CIE 15:2004, section 3.1); below 4000 K, where it is undefined, a black body, as in
/// pbrt-v4. The scale is arbitrary.
DenseCurve daylight(double kelvin) {
    const double t = kelvin * 1.4388 / 1.4380;  // the second radiation constant has been redefined since
    if (t < 4000) return Spectrum::blackbody(t).dense();
    const double x = t <= 7000 ? -4.607e9 / (t * t * t) + 2.9678e6 / (t * t) + 0.09911e3 / t + 0.244063
                               : -2.0064e9 / (t * t * t) + 1.9018e6 / (t * t) + 0.24748e3 / t + 0.23704;
    const double y = -3 * x * x + 2.87 * x - 0.275;
    const double m = 0.0241 + 0.2562 * x - 0.7341 * y;
    const double m1 = (-1.3515 - 1.7703 * x + 5.9114 * y) / m, m2 = (0.03 - 31.4424 * x + 30.0717 * y) / m;
    const DenseCurve s0 = curveNamed("cie-daylight-S0"), s1 = curveNamed("cie-daylight-S1"), s2 = curveNamed("cie-daylight-S2");
    DenseCurve curve;
    for (int i = 0; i < wavelengthCount; ++i) curve[i] = std::max(0.0, s0[i] + m1 * s1[i] + m2 * s2[i]);
    return curve;
}

/// The matrix that maps `from` to `to` with the least squared error.
glm::dmat3 leastSquares(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to) {
    glm::dmat3 crossed(0), squared(0);
    for (size_t i = 0; i < from.size(); ++i) {
        crossed += glm::outerProduct(to[i], from[i]);
        squared += glm::outerProduct(from[i], from[i]);
    }
    return crossed * glm::inverse(squared);
}

std::vector<DenseCurve> chartSwatches() {
    std::vector<DenseCurve> swatches;
    for (const std::string& name : spectrumNames())
        if (name.starts_with("swatch-")) swatches.push_back(curveNamed(name));
    return swatches;
}

struct Camera {
    DenseCurve r, g, b;
    glm::dvec3 respond(const DenseCurve& light) const {
        return {integral(times(r, light)), integral(times(g, light)), integral(times(b, light))};
    }
};

/// pbrt-v4's matrix from a camera's response to XYZ: it maps the chart under `white` to the chart under the output's white.
glm::dmat3 xyzFromResponse(const Camera& camera, const DenseCurve& white, ColorSpace output) {
    const DenseCurve& target = whiteSpectrum(output);
    const double brightness = integrateXyz(white).y / integral(times(camera.g, white));
    std::vector<glm::dvec3> responses, colors;
    for (const DenseCurve& swatch : chartSwatches()) {
        responses.push_back(camera.respond(times(swatch, white)) / integral(times(camera.g, white)));
        colors.push_back(integrateXyz(times(swatch, target)) / integrateXyz(target).y * brightness);
    }
    return leastSquares(responses, colors);
}

/// The camera's response to linear sRGB, fitted to light reflected by the chart.
glm::dmat3 responseFromLinearSrgb(const Camera& camera) {
    std::vector<glm::dvec3> colors, responses;
    for (const char* illuminant : {"stdillum-D65", "stdillum-D50", "stdillum-A"})
        for (const DenseCurve& swatch : chartSwatches()) {
            const DenseCurve light = times(swatch, curveNamed(illuminant));
            colors.push_back(rgbFromXyz(ColorSpace::srgb) * integrateXyz(light));
            responses.push_back(camera.respond(light));
        }
    return leastSquares(colors, responses);
}

}  // namespace

/// The matrix that maps the daylight to be balanced to the output's white, in XYZ (von Kries adaptation).
static glm::dmat3 balanceOf(const SensorDescription& sensor) {
    if (!(sensor.whiteBalance > 0)) return glm::dmat3(1);
    const glm::dvec3 source = integrateXyz(daylight(sensor.whiteBalance));
    const glm::dvec3 gains = (conesFromXyz * xyzOf(whitePoint(sensor.output))) / (conesFromXyz * (source / source.y));
    const glm::dmat3 scale(gains.x, 0, 0, 0, gains.y, 0, 0, 0, gains.z);
    return glm::inverse(conesFromXyz) * scale * conesFromXyz;
}

static Camera cameraNamed(const std::string& name) { return {curveNamed(name + "_r"), curveNamed(name + "_g"), curveNamed(name + "_b")}; }
static DenseCurve whiteOf(const SensorDescription& sensor) { return daylight(sensor.whiteBalance > 0 ? sensor.whiteBalance : 6500); }

std::array<glm::dvec3, wavelengthCount> linearSrgbResponse(const SensorDescription& sensor) {
    std::array<glm::dvec3, wavelengthCount> response = matchingFunctions();
    glm::dmat3 xyzFromSensor = balanceOf(sensor);
    if (sensor.name != "cie1931") {
        const Camera camera = cameraNamed(sensor.name);
        for (int i = 0; i < wavelengthCount; ++i) response[i] = {camera.r[i], camera.g[i], camera.b[i]};
        xyzFromSensor = xyzFromResponse(camera, whiteOf(sensor), sensor.output);
    }
    for (glm::dvec3& r : response) r = sensor.imagingRatio * rgbFromXyz(ColorSpace::srgb) * xyzFromSensor * r;
    return response;
}

glm::dmat3 imageFromLight(const SensorDescription& sensor) {
    const glm::dmat3 imageFromXyz = sensor.imagingRatio * rgbFromXyz(ColorSpace::srgb);
    if (sensor.name == "cie1931") {
        if (!(sensor.whiteBalance > 0)) return glm::dmat3(sensor.imagingRatio);
        return imageFromXyz * balanceOf(sensor) * xyzFromRgb(ColorSpace::srgb);
    }
    const Camera camera = cameraNamed(sensor.name);
    return imageFromXyz * xyzFromResponse(camera, whiteOf(sensor), sensor.output) * responseFromLinearSrgb(camera);
}

std::vector<std::string> sensorNames() {
    std::vector<std::string> names = {"cie1931"};
    for (const std::string& name : spectrumNames())
        if (name.ends_with("_r")) names.push_back(name.substr(0, name.size() - 2));
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace eikonal
