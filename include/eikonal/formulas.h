/* Formulas that the host works out for constants and devices for textures. The only functions in this folder. REAL is float on devices and
   double on the host. */
#ifndef EIKONAL_FORMULAS_H
#define EIKONAL_FORMULAS_H

#ifdef __OPENCL_VERSION__
#define FORMULA FN   /* kernels/math/portable.clh */
#define REAL float
#define CONSTANT(x) x##f
#else
#include <cmath>
#define FORMULA inline
#define REAL double
#define CONSTANT(x) x
namespace eikonal {
using std::log;
using std::sqrt;
#endif

FORMULA REAL limit_to(REAL x, REAL low, REAL high) {
    REAL above = x > low ? x : low;
    return above < high ? above : high;
}

/* k of a metal with eta = 1 and reflectance r at normal incidence. */
FORMULA REAL metal_k(REAL r) {
    REAL reflectance = limit_to(r, CONSTANT(0.0), CONSTANT(0.9999));
    return CONSTANT(2.0) * sqrt(reflectance / (CONSTANT(1.0) - reflectance));
}

/* pbrt-v4's regularization of a microfacet width: narrow lobes are widened. */
FORMULA REAL regular_width(REAL alpha) {
    return alpha < CONSTANT(0.3) ? limit_to(CONSTANT(2.0) * alpha, CONSTANT(0.1), CONSTANT(0.3)) : alpha;
}

/* Absorption of hair with colour c in [0, 1]: squared_log(c) * hair_absorption_scale(beta_n), a fit of Chiang et al. 2016 (equation 9). */
FORMULA REAL squared_log(REAL c) {
    REAL root = log(limit_to(c, CONSTANT(1e-6), CONSTANT(1.0)));
    return root * root;
}
FORMULA REAL hair_absorption_scale(REAL n) {
    REAL fit = CONSTANT(5.969) +
               n * (CONSTANT(-0.215) + n * (CONSTANT(2.532) + n * (CONSTANT(-10.73) + n * (CONSTANT(5.574) + n * CONSTANT(0.245)))));
    return CONSTANT(1.0) / (fit * fit);
}

/* d of the diffusion profile of a body, from its mean free path with reduced scattering and its diffuse albedo: path / (1.85 - albedo +
   7 |albedo - 0.8|^3) (Christensen and Burley 2015, equation 5: light enters perpendicularly, no internal reflection). Internal reflection
   keeps light inside longer: random walks behind a boundary have profiles of the same shape that are up to about eta^2 times as wide, less
   at low albedos. stretch: max(eta^2, 1) - 1; the fit is ours (docs/subsurface.md). */
FORMULA REAL profile_length(REAL path, REAL albedo, REAL stretch) {
    REAL from_white = albedo > CONSTANT(0.8) ? albedo - CONSTANT(0.8) : CONSTANT(0.8) - albedo;
    REAL share = CONSTANT(3.0) * albedo;
    REAL wider = CONSTANT(1.0) + stretch * (share < CONSTANT(0.9) ? share : CONSTANT(0.9));
    return path * wider / (CONSTANT(1.85) - albedo + CONSTANT(7.0) * from_white * from_white * from_white);
}

#undef FORMULA
#undef REAL
#undef CONSTANT
#ifndef __OPENCL_VERSION__
}
#endif
#endif
