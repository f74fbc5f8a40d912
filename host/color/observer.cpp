#include "color/observer.h"

#include <algorithm>
#include <cctype>

namespace eikonal {
namespace {

struct Primaries {
    const char* name;
    const char* white;
    glm::dvec2 r, g, b;  ///< chromaticities
};

// In the order of ColorSpace.
constexpr int spaceCount = 4;
const Primaries spaces[spaceCount] = {
    {"srgb", "stdillum-D65", {.64, .33}, {.3, .6}, {.15, .06}},                     // ITU-R BT.709
    {"dci-p3", "stdillum-D65", {.68, .32}, {.265, .69}, {.15, .06}},                // SMPTE RP 431-2, white of Display P3
    {"rec2020", "stdillum-D65", {.708, .292}, {.17, .797}, {.131, .046}},           // ITU-R BT.2020
    {"aces2065-1", "illum-acesD60", {.7347, .2653}, {0, 1}, {.0001, -.077}},        // SMPTE ST 2065-1
};

struct Space {
    DenseCurve white;
    glm::dvec2 whitePoint;
    glm::dmat3 xyzFromRgb, rgbFromXyz;
};

Space makeSpace(const Primaries& primaries) {
    const auto xyz = [](glm::dvec2 xy) { return glm::dvec3(xy.x, xy.y, 1 - xy.x - xy.y) / xy.y; };
    Space space;
    space.white = densify(*namedSpectrum(primaries.white));
    glm::dvec3 white = integrateXyz(space.white);
    white /= white.y;
    space.whitePoint = glm::dvec2(white) / (white.x + white.y + white.z);
    const glm::dmat3 directions(xyz(primaries.r), xyz(primaries.g), xyz(primaries.b));
    const glm::dvec3 strengths = glm::inverse(directions) * white;
    space.xyzFromRgb = glm::dmat3(directions[0] * strengths.x, directions[1] * strengths.y, directions[2] * strengths.z);
    space.rgbFromXyz = glm::inverse(space.xyzFromRgb);
    return space;
}

const Space& get(ColorSpace space) {
    static const std::array<Space, spaceCount> made = {makeSpace(spaces[0]), makeSpace(spaces[1]), makeSpace(spaces[2]),
                                                       makeSpace(spaces[3])};
    return made[static_cast<int>(space)];
}

}  // namespace

DenseCurve densify(const SampledCurve& curve) {
    DenseCurve dense;
    for (int i = 0; i < wavelengthCount; ++i) dense[i] = curve(shortestWavelength + i);
    return dense;
}

const std::array<glm::dvec3, wavelengthCount>& matchingFunctions() {
    static const auto functions = [] {
        const DenseCurve x = densify(*namedSpectrum("cie1931-X"));
        const DenseCurve y = densify(*namedSpectrum("cie1931-Y"));
        const DenseCurve z = densify(*namedSpectrum("cie1931-Z"));
        std::array<glm::dvec3, wavelengthCount> result;
        for (int i = 0; i < wavelengthCount; ++i) result[i] = {x[i], y[i], z[i]};
        return result;
    }();
    return functions;
}

glm::dvec3 integrateXyz(const DenseCurve& curve) {
    glm::dvec3 sum(0);
    for (int i = 0; i < wavelengthCount; ++i) sum += matchingFunctions()[i] * curve[i];
    return sum;
}

std::optional<ColorSpace> colorSpaceNamed(const std::string& name) {
    std::string lower = name;
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
    for (int i = 0; i < spaceCount; ++i)
        if (lower == spaces[i].name) return static_cast<ColorSpace>(i);
    return std::nullopt;
}

std::vector<std::string> colorSpaceNames() {
    std::vector<std::string> names;
    for (const Primaries& space : spaces) names.push_back(space.name);
    return names;
}

const DenseCurve& whiteSpectrum(ColorSpace space) { return get(space).white; }
glm::dvec2 whitePoint(ColorSpace space) { return get(space).whitePoint; }
const glm::dmat3& xyzFromRgb(ColorSpace space) { return get(space).xyzFromRgb; }
const glm::dmat3& rgbFromXyz(ColorSpace space) { return get(space).rgbFromXyz; }

}  // namespace eikonal
