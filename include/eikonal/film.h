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
    F(q, spectrum, albedo,       AOVS)     /* sums of weight * what the path saw */ \
    F(q, vec3,     normal,       AOVS) \
    F(q, vec3,     ng,           AOVS) \
    F(q, vec3,     position,     AOVS)     /* sums over the samples that saw a surface ... */ \
    F(q, float,    distance,     AOVS) \
    F(q, float,    seen,         AOVS)     /* ... and their number */ \
    F(q, uint,     object,       AOVS)     /* of most samples, by majority vote (Boyer and Moore 1991) ... */ \
    F(q, uint,     object_lead,  AOVS)     /* ... and its lead */ \
    F(q, uint,     material,     AOVS) \
    F(q, uint,     material_lead, AOVS)

CONTRACT_END
#endif
