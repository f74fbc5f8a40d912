/* The film: what is kept of a pixel's samples. A sample contributes to its own pixel only, so crops and tiles join exactly. */
#ifndef EIKONAL_FILM_H
#define EIKONAL_FILM_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

/* P(type, name, FEATURE). Sums run in the order of the samples and are compensated (Kahan), so that neither the wave
   size nor a million samples change their last bits. */
#define FILM_FIELDS(F, q) \
    F(q, spectrum, sum,          ALWAYS)   /* of weight * L */ \
    F(q, spectrum, compensation, ALWAYS)   /* what the sum has lost to rounding */ \
    F(q, float,    weight,       ALWAYS)   /* sum of weights */ \
    F(q, float,    square,       ALWAYS)   /* sum of (weight * luminance)^2 */ \
    F(q, uint,     count,        ALWAYS)   /* samples */ \
    F(q, uint,     invalid,      ALWAYS)   /* samples that were not finite, counted as black */ \
    F(q, spectrum, albedo,       AOVS)     /* sums of weight * the first surface's */ \
    F(q, vec3,     normal,       AOVS) \
    F(q, float,    distance,     AOVS)     /* sum over the samples that saw a surface ... */ \
    F(q, float,    seen,         AOVS)     /* ... and their number */

CONTRACT_END
#endif
