#include "kinds/filter_kind.h"

#include "read/pbrt/arguments.h"
#include "scene/film.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

static double evalBox(const FilterDescription&, double, double) { return 1; }
const FilterKind box_filter{"box", "float xradius = 0.5 in (0, inf); float yradius = 0.5 in (0, inf)", nullptr, evalBox};

static double evalTriangle(const FilterDescription&, double x, double radius) { return radius - x; }
const FilterKind triangle_filter{"triangle", "float xradius = 2 in (0, inf); float yradius = 2 in (0, inf)", nullptr, evalTriangle};

static void readGaussian(const pbrt::Arguments& arguments, FilterDescription& f) { f.sigma = arguments.number("sigma"); }
static double evalGaussian(const FilterDescription& f, double x, double radius) {
    const auto gaussian = [&](double d) { return std::exp(-d * d / (2 * f.sigma * f.sigma)); };
    return std::max(0.0, gaussian(x) - gaussian(radius));
}
const FilterKind gaussian_filter{"gaussian",
                                 "float xradius = 1.5 in (0, inf); float yradius = 1.5 in (0, inf); float sigma = 0.5 in (0, inf)",
                                 readGaussian, evalGaussian};

static void readMitchell(const pbrt::Arguments& arguments, FilterDescription& f) {
    f.B = arguments.number("B", 1. / 3);
    f.C = arguments.number("C", 1. / 3);
}
/// Mitchell and Netravali 1988, whose filter has the support [-2, 2].
static double evalMitchell(const FilterDescription& f, double x, double radius) {
    const double t = 2 * x / radius, B = f.B, C = f.C;
    if (t <= 1) return ((12 - 9 * B - 6 * C) * t * t * t + (-18 + 12 * B + 6 * C) * t * t + (6 - 2 * B)) / 6;
    return ((-B - 6 * C) * t * t * t + (6 * B + 30 * C) * t * t + (-12 * B - 48 * C) * t + (8 * B + 24 * C)) / 6;
}
const FilterKind mitchell_filter{"mitchell", "float xradius = 2 in (0, inf); float yradius = 2 in (0, inf); float B; float C", readMitchell,
                                 evalMitchell};

static void readSinc(const pbrt::Arguments& arguments, FilterDescription& f) { f.tau = arguments.number("tau"); }
/// A sinc windowed by a wider sinc (Lanczos).
static double evalSinc(const FilterDescription& f, double x, double) {
    const auto sinc = [](double t) { return std::abs(t) < 1e-5 ? 1 : std::sin(M_PI * t) / (M_PI * t); };
    return sinc(x) * sinc(x / f.tau);
}
const FilterKind sinc_filter{"sinc", "float xradius = 4 in (0, inf); float yradius = 4 in (0, inf); float tau = 3 in (0, inf)", readSinc,
                             evalSinc};

std::span<const FilterKind* const> filterKindList() {
    static const FilterKind* const kinds[] = {&box_filter, &triangle_filter, &gaussian_filter, &mitchell_filter, &sinc_filter};
    return kinds;
}

}  // namespace eikonal
