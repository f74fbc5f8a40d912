/* Every kind of texture. A texture is a program in postfix order: each instruction pops zero or more operands and pushes one value, so
   scale(mix(image, checks)) needs no recursion. Values are spectra; a float is the same in all channels.
   T(name, FEATURE, OPERANDS): texture x is kernels/texture/x.clh, which defines eval_x_texture, beside host/kinds/texture/x.cpp. */
#ifndef EIKONAL_TEXTURES_H
#define EIKONAL_TEXTURES_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

#define TEXTURES(T) \
    T(constant,      TEXTURE_CONSTANT,      0)  /* `value` */ \
    T(imagemap,      TEXTURE_IMAGEMAP,      0)  /* filtered lookup of `image`, times value.scale; inverted with texture_invert */ \
    T(scale,         TEXTURE_SCALE,         2)  /* a, b: a * b */ \
    T(mix,           TEXTURE_MIX,           3)  /* a, b, amount: (1 - amount) a + amount b */ \
    T(checkerboard,  TEXTURE_CHECKERBOARD,  2)  /* a, b: a where the sum of the cell's integer coordinates is even, else b */ \
    T(bilerp,        TEXTURE_BILERP,        4)  /* v00, v01, v10, v11: bilinear interpolation between these corners */ \
    T(dots,          TEXTURE_DOTS,          2)  /* a, b: a inside dots, b between them */ \
    T(directionmix,  TEXTURE_DIRECTIONMIX,  2)  /* a, b: blend(b, a, |cos| of the geometric normal and `direction`) */ \
    T(fbm,           TEXTURE_FBM,           0)  /* `octaves` of noise, `roughness` */ \
    T(wrinkled,      TEXTURE_WRINKLED,      0)  /* the same with the noise's absolute value */ \
    T(windy,         TEXTURE_WINDY,         0)  /* water waves */ \
    T(marble,        TEXTURE_MARBLE,        0)  /* `octaves`, `roughness`, `variation` */ \
    T(absorption,    TEXTURE_ABSORPTION,    2)  /* hair colour, beta_n: absorption coefficient */ \
    T(diffusealbedo, TEXTURE_DIFFUSEALBEDO, 2)  /* sigma_a, sigma_s: diffuse albedo of a semi-infinite body; g in value.scale */ \
    T(freepath,      TEXTURE_FREEPATH,      2)  /* sigma_a, sigma_s: mean free path with reduced scattering; g in value.scale */

/* What a program may do to its value at its end, by what the value is used for: kernels/texture/operations.clh. */
#define TEXTURE_OPERATIONS(T) \
    T(clamp,         TEXTURE_CLAMP,         1)  /* the value clamped to [0, 1] */ \
    T(sqrt,          TEXTURE_SQRT,          1)  /* square root, which maps a roughness to a microfacet width */ \
    T(regular,       TEXTURE_REGULAR,       1)  /* regularized microfacet width */ \
    T(metal,         TEXTURE_METAL,         1)  /* reflectance of a metal to its k with eta = 1 */

#define TEXTURE_KIND(name, FEATURE, OPERANDS) kind_##name##_texture,
enum texture_kind { TEXTURES(TEXTURE_KIND) TEXTURE_OPERATIONS(TEXTURE_KIND) texture_kinds };

CONTRACT_END
#endif
