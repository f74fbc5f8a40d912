/* The types that both compilers share. The contract headers (this folder) are read by the C++ compiler and by OpenCL C:
   they hold lists, enumerations and plain structs of 32-bit words, and no logic.
   Everything is made of 4-byte words, so a struct has the same layout in both languages; `layout_probe` proves it. */
#ifndef EIKONAL_PORTABLE_H
#define EIKONAL_PORTABLE_H

#ifdef __OPENCL_VERSION__
#define CONTRACT_BEGIN
#define CONTRACT_END
#else
#include <cstdint>
#define CONTRACT_BEGIN namespace eikonal {
#define CONTRACT_END }
#endif

CONTRACT_BEGIN

#ifndef __OPENCL_VERSION__
using uint = std::uint32_t;
#endif

/* Scalars side by side, not OpenCL vectors: a float3 in a shading kernel stops PoCL's vectoriser (docs/performance.md). */
typedef struct { float x, y; } vec2;
typedef struct { float x, y, z; } vec3;

/* A distribution over wavelengths as a path carries it: throughput, radiance, a BSDF's parameter. Three channels of linear sRGB or,
   with SPECTRAL, the values at four wavelengths of the path's own (kernels/shade/color.clh).
   Only kernels/shade/spectrum.clh and queue.clh know how many channels there are. */
#if HAS_SPECTRAL
typedef struct { float r, g, b, x; } spectrum;
#else
typedef struct { float r, g, b; } spectrum;
#endif
#define CHANNELS_RGB 3
#define CHANNELS_SPECTRAL 4

/* What a pixel holds: linear sRGB. */
typedef struct { float r, g, b; } rgb;

/* A distribution over wavelengths as a table holds it: eval_color (kernels/shade/color.clh) makes a spectrum of it. A number (what is the
   same at all wavelengths) can be read from `scale` alone. */
typedef struct {
    float c0, c1, c2;    /* linear sRGB; with SPECTRAL the coefficients of a smooth spectrum: see eval_smooth */
    float scale;         /* with SPECTRAL: times this */
    uint curve;          /* with SPECTRAL: times this one of `curves` */
} color;

/* Rows of an affine map from one space to another: p' = (dot(row_x.xyz, p) + row_x.w, ...). */
typedef struct { float xx, xy, xz, xw, yx, yy, yz, yw, zx, zy, zz, zw; } affine;

#define WORDS_uint 1
#define WORDS_float 1
#define WORDS_vec2 2
#define WORDS_vec3 3
#define WORDS_color 5
#if HAS_SPECTRAL
#define WORDS_spectrum CHANNELS_SPECTRAL
#else
#define WORDS_spectrum CHANNELS_RGB
#endif
#define WORDS_rgb 3

/* "No such index", for every table. */
#define NONE 0xffffffffu

/* The longest distance. Finite, since the kernels are built with -cl-finite-math-only, where an infinity is undefined. */
#define FAR_AWAY 1e30f
/* A shadow ray ends this fraction short of the light, so as not to hit it. */
#define SHADOW_EPSILON 1e-4f

CONTRACT_END
#endif
