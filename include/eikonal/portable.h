/* Types shared by both compilers. C++ and OpenCL C both read the contract headers (this folder):
   they hold lists, enumerations and plain structs of 32-bit words, and no logic (but formulas.h).
   Structs consist of 4-byte words only, so both languages give them the same layout; `layout_probe` tests it. */
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

/* Structs of scalars, not OpenCL vectors: a float3 in a shading kernel stops PoCL's vectoriser (docs/performance.md). */
typedef struct { float x, y; } vec2;
typedef struct { float x, y, z; } vec3;

/* A spectrum as a path carries it: throughput, radiance, a parameter of a BSDF. Three channels of linear sRGB or, with SPECTRAL,
   values at the path's four sampled wavelengths (kernels/shade/color.clh).
   Only kernels/shade/spectrum.clh and queue.clh know the number of channels. */
#if HAS_SPECTRAL
typedef struct { float r, g, b, x; } spectrum;
#else
typedef struct { float r, g, b; } spectrum;
#endif
#define CHANNELS_RGB 3
#define CHANNELS_SPECTRAL 4

/* A pixel value: linear sRGB. */
typedef struct { float r, g, b; } rgb;

/* A spectrum as a table stores it; eval_color (kernels/shade/color.clh) makes a spectrum of it. A number (the same at all wavelengths) can
   be read from `scale` alone. */
typedef struct {
    float c0, c1, c2;    /* linear sRGB; with SPECTRAL: coefficients of a smooth spectrum, see eval_smooth */
    float scale;         /* with SPECTRAL: a factor */
    uint curve;          /* with SPECTRAL: another factor, one of `curves` */
} color;
/* c2 of a colour that is its curve alone: there, with c0 and c1 of 0, the smooth spectrum is 1. */
#define SATURATED 1e6f

/* Rows of an affine map between two spaces: p' = (dot(row_x.xyz, p) + row_x.w, ...). */
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

/* "No such index", in every table. */
#ifdef __OPENCL_VERSION__
#define NONE 0xffffffffu
#else
constexpr uint NONE = 0xffffffffu; /* no macro: libraries have enumerators of this name */
#endif

/* The largest distance. Finite, since kernels are built with -cl-finite-math-only, where infinity is undefined. */
#define FAR_AWAY 1e30f
/* Shadow rays end at most this fraction of their length before the light, to avoid hitting what it lies on. */
#define SHADOW_EPSILON 1e-4f

CONTRACT_END
#endif
