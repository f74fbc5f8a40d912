/* The film: statistics of each pixel's samples. A sample contributes to its own pixel only, so crops and tiles join exactly. */
#ifndef EIKONAL_FILM_H
#define EIKONAL_FILM_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

/* F(queue, type, name, FEATURE). Samples are added in order, one after the other, so wave size, tiles and crops do not change a bit.
   What the image shows is summed with compensation (Kahan), so a million samples lose no more precision than a few. Plain sums are
   `normal` and `ng`, whose lengths do not matter, and those that only the error estimate reads. */
#define FILM_FIELDS(F, q) \
    F(q, rgb,      sum,           ALWAYS)   /* of weight * film response to L */ \
    F(q, rgb,      compensation,  ALWAYS)   /* rounding error of sum */ \
    F(q, float,    weight,        ALWAYS)   /* sum of weights */ \
    F(q, float,    weight_excess, ALWAYS)   /* rounding error of weight */ \
    F(q, float,    square_weight, ALWAYS)   /* sum of weight^2 */ \
    F(q, float,    mean,          ALWAYS)   /* of luminance, weighted by weight^2 */ \
    F(q, float,    spread,        ALWAYS)   /* sum of weight^2 * (luminance - mean)^2, at most MOST_SPREAD */ \
    F(q, float,    quarter0,      ALWAYS)   /* sums of weight * luminance over quarters of 2^k samples (kernels/film/quarters.clh) */ \
    F(q, float,    quarter1,      ALWAYS) \
    F(q, float,    quarter2,      ALWAYS) \
    F(q, float,    quarter3,      ALWAYS) \
    F(q, float,    weight0,       FILTER)   /* sums of their weights, which differ from the number of samples with a filter only */ \
    F(q, float,    weight1,       FILTER) \
    F(q, float,    weight2,       FILTER) \
    F(q, float,    weight3,       FILTER) \
    F(q, float,    low_mean,      ALWAYS)   /* of the last 2^k samples: mean luminance of all quarters but the brightest */ \
    F(q, float,    half_square,   ALWAYS)   /* squared distance of their mean from that of half of them */ \
    F(q, float,    quarter_square, ALWAYS)  /* the same for each half and its quarters, averaged over both halves */ \
    F(q, float,    eighth_square, ALWAYS)   /* quarter_square of the last 2^(k-1) samples: of quarters and their eighths */ \
    F(q, uint,     count,         ALWAYS)   /* samples */ \
    F(q, uint,     invalid,       ALWAYS)   /* samples not finite or above MOST_RADIANCE, counted as black */ \
    F(q, rgb,      emission,     RENDER_PASSES) /* of weight * film response to L_emission; the next three likewise */ \
    F(q, rgb,      direct,       RENDER_PASSES) \
    F(q, rgb,      indirect,     RENDER_PASSES) \
    F(q, rgb,      volume,       RENDER_PASSES) \
    F(q, rgb,      emission_compensation, RENDER_PASSES) /* rounding errors of these sums */ \
    F(q, rgb,      direct_compensation,   RENDER_PASSES) \
    F(q, rgb,      indirect_compensation, RENDER_PASSES) \
    F(q, rgb,      volume_compensation,   RENDER_PASSES) \
    F(q, rgb,      albedo,       AOVS)     /* sum of weight * value; the same for the next two */ \
    F(q, vec3,     normal,       AOVS) \
    F(q, vec3,     ng,           AOVS) \
    F(q, vec3,     position,     AOVS)     /* sum over the samples that hit a surface; the same for the next four */ \
    F(q, vec2,     uv,           AOVS) \
    F(q, vec3,     opening,      MOTION_VECTORS) /* of the surface point at shutter open */ \
    F(q, vec3,     closing,      MOTION_VECTORS) /* of the surface point at shutter close */ \
    F(q, float,    distance,     AOVS) \
    F(q, float,    seen,         AOVS)     /* number of samples that hit a surface */ \
    F(q, rgb,      albedo_compensation,   AOVS)           /* rounding errors of these sums */ \
    F(q, vec3,     position_compensation, AOVS) \
    F(q, vec2,     uv_compensation,       AOVS) \
    F(q, vec3,     opening_compensation,  MOTION_VECTORS) \
    F(q, vec3,     closing_compensation,  MOTION_VECTORS) \
    F(q, float,    distance_compensation, AOVS) \
    F(q, uint,     object,       AOVS)     /* of most samples, by majority vote (Boyer and Moore 1991) */ \
    F(q, uint,     object_lead,  AOVS)     /* lead of the current candidate */ \
    F(q, uint,     material,     AOVS) \
    F(q, uint,     material_lead, AOVS)

/* With SPECTRAL_FILM the `bucket_count` buckets (settings) of the pixel's spectrum follow, of two words each: the sum of weight * L at the
   wavelengths of its samples that lie in the bucket, and the rounding error of that sum. */
#define BUCKET_WORDS 2

/* With LIGHT_GROUPS, LIGHT_GROUP_COUNT groups follow, of these words each: the sum of weight * film response to the group's light, and its
   rounding error. */
#define GROUP_WORDS (2 * WORDS_rgb)

/* With FIREFLIES, BRIGHTNESS_BANDS bands follow, of GROUP_WORDS words each: the sum of weight * film response to L of samples whose
   luminance is about LEAST_BRIGHTNESS times the k-th power of BAND_RATIO, and its rounding error (kernels/film/bands.clh). */
#define BRIGHTNESS_BANDS 8
#define LEAST_BRIGHTNESS 0.125f
#define BAND_RATIO 8.0f

/* With CRYPTO_OBJECT, MATTE_SLOTS slots for objects follow; then, with CRYPTO_MATERIAL, as many for materials. A slot has MATTE_WORDS
   words: a Cryptomatte ID (host/image/cryptomatte.h), or NO_SURFACE_ID, or 0 if the slot is free; and the sum of the weights of the samples
   whose first surface has that ID. A leaf has as many samples (host/film/sample_nodes.h), so no ID of it lacks a slot; where leaves join,
   the host keeps the IDs that weigh most (host/film/join_mattes.h). */
#define MATTE_SLOTS 16
#define MATTE_WORDS 2
/* The first surface that is none. No name has this ID. */
#define NO_SURFACE_ID 1u

/* LIGHT_PATHS: what light paths add to pixels. 64-bit integers: of each the low halves of all pixels, then the high ones. They sum what
   each path adds, times splat_scale (settings): colours in steps of 1 / SPLAT_UNITS, and squared luminances in steps of 1 /
   SPLAT_SQUARE_UNITS, whose sum is the variance of a sum of rare events. The image is the sum of colours over the number of light paths for
   each pixel of the whole image. A splat of MOST_SPLAT or more is not added but counted; thousands of the largest that are fit into a sum.
   With RENDER_PASSES, what the colours have of the passes "direct" and "volume" follows; the rest of them is of the pass "indirect". */
enum splat_word {
    splat_red, splat_green, splat_blue, splat_square, splat_lost,
    splat_words,
    splat_direct_red = splat_words, splat_direct_green, splat_direct_blue,
    splat_volume_red, splat_volume_green, splat_volume_blue,
    splat_words_with_passes
};
#define SPLAT_UNITS 0x1p40f
#define MOST_SPLAT 0x1p11f
#define SPLAT_SQUARE_UNITS 0x1p40f
#define MOST_SPLAT_SQUARE 0x1p14f

/* Brighter samples count as invalid. A million samples of this value still sum to a finite float. The sun is 1e9. */
#define MOST_RADIANCE 1e31f
/* Sums are clamped to this. */
#define MOST_SUM 3e38f
/* `spread` is clamped to this, since larger squares overflow a float. */
#define MOST_SPREAD 1e36f

CONTRACT_END
#endif
