/* The film: what is kept of a pixel's samples. A sample contributes to its own pixel only, so crops and tiles join exactly. */
#ifndef EIKONAL_FILM_H
#define EIKONAL_FILM_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

/* F(queue, type, name, FEATURE). Samples are taken in their order, each after the one before, so that wave sizes, tiles and crops change no
   bit. The sums that make the image are compensated (Kahan), so that a million samples lose no more than a few do. */
#define FILM_FIELDS(F, q) \
    F(q, rgb,      sum,           ALWAYS)   /* of weight * what the film makes of L */ \
    F(q, rgb,      compensation,  ALWAYS)   /* what the sum has too much by rounding */ \
    F(q, float,    weight,        ALWAYS)   /* sum of weights */ \
    F(q, float,    weight_excess, ALWAYS)   /* what that sum has too much by rounding */ \
    F(q, float,    square_weight, ALWAYS)   /* sum of weight^2 */ \
    F(q, float,    mean,          ALWAYS)   /* of luminance, by weight^2 */ \
    F(q, float,    spread,        ALWAYS)   /* sum of weight^2 * (luminance - mean)^2, at most MOST_SPREAD */ \
    F(q, uint,     count,         ALWAYS)   /* samples */ \
    F(q, uint,     invalid,       ALWAYS)   /* samples that were not finite or above MOST_RADIANCE, counted as black */ \
    F(q, rgb,      albedo,       AOVS)     /* sums of weight * what the path saw */ \
    F(q, vec3,     normal,       AOVS) \
    F(q, vec3,     ng,           AOVS) \
    F(q, vec3,     position,     AOVS)     /* sums over the samples that saw a surface ... */ \
    F(q, vec2,     uv,           AOVS) \
    F(q, vec3,     opening,      MOTION_VECTORS) /* where those surfaces' points are when the shutter opens ... */ \
    F(q, vec3,     closing,      MOTION_VECTORS) /* ... and when it closes */ \
    F(q, float,    distance,     AOVS) \
    F(q, float,    seen,         AOVS)     /* ... and their number */ \
    F(q, uint,     object,       AOVS)     /* of most samples, by majority vote (Boyer and Moore 1991) ... */ \
    F(q, uint,     object_lead,  AOVS)     /* ... and its lead */ \
    F(q, uint,     material,     AOVS) \
    F(q, uint,     material_lead, AOVS)

/* With SPECTRAL_FILM the buckets of the pixel's spectrum follow, `bucket_count` of them (settings), of two words each: the sum of weight * L at those
   wavelengths of its samples that lie in the bucket, and what that sum has too much by rounding. */
#define BUCKET_WORDS 2

/* The brightest sample that is believed: a million of them still add up to a float. The sun is 1e9. */
#define MOST_RADIANCE 1e31f
/* Where sums stop. */
#define MOST_SUM 3e38f
/* Where it stops to grow: beyond, squares are no floats any more. */
#define MOST_SPREAD 1e36f

CONTRACT_END
#endif
