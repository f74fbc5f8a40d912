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

/* A distribution over wavelengths as a path carries it: throughput, radiance, a BSDF's parameter. Three linear sRGB channels.
   Only kernels/spectrum.clh and queue.clh know how many channels there are. */
typedef struct { float r, g, b; } spectrum;

/* A distribution over wavelengths as a table holds it: eval_color (kernels/color.clh) makes a spectrum of it. Linear sRGB, with
   which of the curves it is to be multiplied. */
typedef struct {
    float c0, c1, c2;    /* red, green, blue */
    float scale;         /* the value of a number: what is the same in all channels */
    uint curve;          /* in `curves` */
} color;

/* Rows of an affine map from one space to another: p' = (dot(row_x.xyz, p) + row_x.w, ...). */
typedef struct { float xx, xy, xz, xw, yx, yy, yz, yw, zx, zy, zz, zw; } affine;

#define WORDS_uint 1
#define WORDS_float 1
#define WORDS_vec2 2
#define WORDS_vec3 3
#define WORDS_color 5
#define WORDS_spectrum 3

/* "No such index", for every table. */
#define NONE 0xffffffffu

/* The longest distance. Finite, since the kernels are built with -cl-finite-math-only, where an infinity is undefined. */
#define FAR_AWAY 1e30f
/* A shadow ray ends this fraction short of the light, so as not to hit it. */
#define SHADOW_EPSILON 1e-4f

CONTRACT_END
#endif
