/* Every texture. A texture is a program: instructions that push one value, or pop some and push one (a postfix
   expression), so that scale(mix(image, checks)) needs no recursion. Values are spectra; a float is the same in all channels.
   T(name, FEATURE).  A texture called x is kernels/texture/x.clh, which defines eval_x. */
#ifndef EIKONAL_TEXTURES_H
#define EIKONAL_TEXTURES_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

/*    name                  FEATURE                 pops, then pushes one */
#define TEXTURES(T) \
    T(constant_texture,     TEXTURE_CONSTANT)     /* 0: `value` */ \
    T(imagemap_texture,     TEXTURE_IMAGEMAP)     /* 0: a filtered lookup of `image`, times value.scale; inverted with texture_invert */ \
    T(scale_texture,        TEXTURE_SCALE)        /* 2: a * b */ \
    T(mix_texture,          TEXTURE_MIX)          /* 3: a, b, amount: (1 - amount) a + amount b */ \
    T(checkerboard_texture, TEXTURE_CHECKERBOARD) /* 2: a where the sum of the cell's numbers is even, else b */ \
    T(bilerp_texture,       TEXTURE_BILERP)       /* 4: v00, v01, v10, v11: between these corners */ \
    T(dots_texture,         TEXTURE_DOTS)         /* 2: a in the dots, b between them */ \
    T(directionmix_texture, TEXTURE_DIRECTIONMIX) /* 2: blend(b, a, |cos| of the geometric normal and `direction`) */ \
    T(fbm_texture,          TEXTURE_FBM)          /* 0: `octaves` of noise, `roughness` */ \
    T(wrinkled_texture,     TEXTURE_WRINKLED)     /* 0: the same of the noise's absolute value */ \
    T(windy_texture,        TEXTURE_WINDY)        /* 0: waves on water */ \
    T(marble_texture,       TEXTURE_MARBLE)       /* 0: `octaves`, `roughness`, `variation` */ \
    T(clamp_texture,        TEXTURE_CLAMP)        /* 1: its value brought into [0, 1] */ \
    T(sqrt_texture,         TEXTURE_SQRT)         /* 1: its square root: a roughness to a microfacet width */ \
    T(regular_texture,      TEXTURE_REGULAR)      /* 1: a microfacet width to that which regularization gives it */ \
    T(absorption_texture,   TEXTURE_ABSORPTION)   /* 2: hair's colour, beta_n: its absorption */ \
    T(metal_texture,        TEXTURE_METAL)        /* 1: a metal's reflectance r to its k for eta = 1: 2 sqrt(r / (1 - r)) */ \
    T(diffusealbedo_texture, TEXTURE_DIFFUSEALBEDO) /* 2: sigma_a, sigma_s: the diffuse albedo of a deep body of these, from the table in `image`; g in value.scale */ \
    T(freepath_texture,     TEXTURE_FREEPATH)     /* 2: sigma_a, sigma_s: the mean free path of reduced scattering; g in value.scale */

#define TEXTURE_KIND(name, FEATURE) kind_##name,
enum texture_kind { TEXTURES(TEXTURE_KIND) texture_kinds };

/* The most values that a program may hold at once. */
#define TEXTURE_STACK 8
/* More octaves of noise than float can tell apart. */
#define MOST_OCTAVES 32

enum texture_mapping { mapping_uv, mapping_spherical, mapping_cylindrical, mapping_planar, mapping_point };
enum texture_flag { texture_invert = 1, texture_number = 2 /* not a colour: value.scale, or the texels as they are */,
                    texture_unbounded = 4 /* colours that are no reflectances: coefficients, an area light's relative radiance */ };

typedef struct {
    uint kind;           /* enum texture_kind */
    uint mapping;        /* enum texture_mapping */
    uint flags;          /* enum texture_flag */
    uint image;          /* in `images`; diffusealbedo: a row of floats over 1 - s, s the similarity parameter (kernels/texture/subsurface.clh) */
    uint octaves;        /* of noise, 0 to MOST_OCTAVES */
    float roughness;     /* of noise: an octave's height over that of the one before */
    float variation;     /* marble: how far noise bends its layers, texture space */
    vec3 direction;      /* directionmix: unit, scene space */
    color value;
    affine texture_from_scene; /* uv: (xx u + xw, yy v + yw); others: of the point */
} texture_instruction;

/* A run of instructions. */
typedef struct { uint first, count; } texture_program;

enum image_wrap { wrap_repeat, wrap_black, wrap_clamp, wrap_octahedral };
enum image_filter { filter_nearest, filter_bilinear };
enum image_format { format_srgb8, format_linear8, format_float };

typedef struct {
    uint width, height;
    uint channels;       /* 1 or 3 (grey or colour), or 4 (colour and alpha) */
    uint format;         /* enum image_format */
    uint wrap;           /* enum image_wrap */
    uint filter;         /* enum image_filter */
    uint first;          /* 8 bit: byte in `byte_texels`; float: word in `float_texels` */
} image;

CONTRACT_END
#endif
