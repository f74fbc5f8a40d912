#include "pack/colors.h"

namespace eikonal {

static float toFloat(double x) { return static_cast<float>(x); }

color packRgb(glm::dvec3 rgb) { return {toFloat(rgb.x), toFloat(rgb.y), toFloat(rgb.z), 1, 0}; }

color packEmission(Packer&, const Spectrum& light, double factor) { return packRgb(light.illuminant() * factor); }

color packReflectance(Packer& packer, const Spectrum& reflectance) { return packCoefficient(packer, reflectance); }

color packCoefficient(Packer&, const Spectrum& coefficient, double factor) {
    if (coefficient.isConstant()) return packNumber(coefficient.value() * factor);
    return packRgb(coefficient.albedo() * factor);
}

color packNumber(double value) {
    color c = packRgb(glm::dvec3(value));
    c.scale = toFloat(value);
    return c;
}

double luminanceOf(const Spectrum& light, double factor) {
    const glm::vec3 rgb(light.illuminant() * factor);
    return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z;
}

}  // namespace eikonal
