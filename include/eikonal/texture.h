/* A texture as kernels see it: a program. The kinds of its instructions: textures.h. */
#ifndef EIKONAL_TEXTURE_H
#define EIKONAL_TEXTURE_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

/* Size of the evaluation stack. */
#define TEXTURE_STACK 8
/* More octaves of noise than a float can resolve. */
#define MOST_OCTAVES 32

enum texture_mapping { mapping_uv, mapping_spherical, mapping_cylindrical, mapping_planar, mapping_point };
enum texture_flag { texture_invert = 1, texture_number = 2 /* not a colour: value.scale, or the texels unconverted */,
                    texture_unbounded = 4 /* colours that are not reflectances: coefficients, or relative radiance of an area light */ };

typedef struct {
    uint kind;           /* enum texture_kind */
    uint mapping;        /* enum texture_mapping */
    uint flags;          /* enum texture_flag */
    /* in `images`; diffusealbedo: one row of floats over 1 - s, where s is the similarity parameter (kernels/texture/subsurface.clh) */
    uint image;
    uint octaves;        /* of noise, 0 to MOST_OCTAVES */
    float roughness;     /* of noise: amplitude ratio of successive octaves */
    float variation;     /* marble: how far noise displaces its layers, texture space */
    vec3 direction;      /* directionmix: unit vector, world space */
    color value;
    affine texture_from_scene; /* uv: (xx u + xw, yy v + yw); directionmix: scene from world; others: applied to the point */
} texture_instruction;

/* The instructions of one texture; and over which difference of (u, v), and which distance in the space of points, a bump map takes its
   slopes: the smaller one counts. */
typedef struct { uint first, count; float bump_step_uv, bump_step; } texture_program;

enum image_wrap { wrap_repeat, wrap_black, wrap_clamp, wrap_octahedral };
enum image_filter { filter_nearest, filter_bilinear };
enum image_format { format_srgb8, format_linear8, format_float };

typedef struct {
    uint width, height;
    uint channels;       /* 1 or 3 (grey or colour), or 4 (colour and alpha) */
    uint format;         /* enum image_format */
    uint wrap;           /* enum image_wrap */
    uint filter;         /* enum image_filter */
    uint first;          /* 8 bit: first byte in `byte_texels`; float: first word in `float_texels` */
} image;

CONTRACT_END
#endif
