/* Everything that a scene may require. On the device a feature X is the macro HAS_X, 0 or 1, and code tests `if (HAS_X)`;
   on the host it is a bit of `Features` (host/feature_set.h). A kernel's program is built with only those features that its
   source mentions, so scenes can share binaries.   F(NAME, what requires it) */
#ifndef EIKONAL_FEATURES_H
#define EIKONAL_FEATURES_H
#include "eikonal/bsdfs.h"
#include "eikonal/cameras.h"
#include "eikonal/lights.h"
#include "eikonal/media.h"
#include "eikonal/shapes.h"
#include "eikonal/textures.h"

#define GENERAL_FEATURES(F) \
    F(SPECTRAL,         "rendering at wavelengths instead of in RGB") \
    F(SPECTRAL_FILM,    "a film that keeps a spectrum of each pixel") \
    F(DISPERSION,       "an index of refraction that depends on the wavelength") \
    F(MEDIA,            "a participating medium") \
    F(SUBSURFACE,       "a body that light enters, wanders in and leaves") \
    F(DIFFUSION,        "such a body, whose light leaves by a diffusion profile") \
    F(BODY_TEXTURES,    "such a body, of which a texture says what is inside") \
    F(EQUIANGULAR,             "a light that is a point, and a homogeneous medium that scatters") \
    F(INTERFACE,        "a surface of material \"interface\"") \
    F(INSTANCES,        "object instances") \
    F(ALPHA,            "shapes cut out by an alpha texture") \
    F(MIX,              "a mix of materials") \
    F(LAYERS,           "a coat over a base") \
    F(LAYER_MEDIUM,     "a coat with something between it and its base") \
    F(TEXTURED,         "a material parameter that varies over its surface") \
    F(TRANSMISSION,     "a material that transmits") \
    F(ANISOTROPY,       "a material whose look depends on the direction along the surface") \
    F(TANGENTS,         "a mesh that says which way its tangents run") \
    F(GRAIN,            "a measured surface that was measured from all around") \
    F(BUMP,             "a displacement texture") \
    F(NORMAL_MAP,       "a normal map") \
    F(EMITTERS,         "a surface that emits") \
    F(LIGHT_PATTERN,    "an area light with an image, or cut out by an alpha texture") \
    F(LIGHTS,           "a light that can be sampled") \
    F(LIGHT_TREE,       "many lights, or \"lightsampler\" \"bvh\"") \
    F(ENVIRONMENT_GUIDE, "a constant infinite light, sampled where surfaces see it") \
    F(PORTALS,          "an infinite light with a portal") \
    F(LENS,             "a lens with an aperture") \
    F(APERTURE,         "an aperture that is not round") \
    F(IMPORTANCE,       "a film that receives more light through some rays than through others") \
    F(MOTION,           "a shape that moves") \
    F(CAMERA_MOTION,    "a camera that moves") \
    F(FILTER,           "a pixel filter other than a box of one pixel") \
    F(SOBOL,            "a low-discrepancy sampler") \
    F(JOINT_PAIRS,      "a sampler that spreads pairs of numbers together") \
    F(REGULARIZE,       "an integrator that regularizes") \
    F(AMBIENT_OCCLUSION, "an integrator that only looks for what is near") \
    F(RAY_SPLITTING,    "an integrator that follows trees of rays") \
    F(UNIFORM_DIRECTIONS, "an integrator that knows of no better directions than uniform ones") \
    F(AOVS,             "auxiliary image channels") \
    F(MOTION_VECTORS,   "the channel \"motion\", and a shape that moves")

/* Calls F(FEATURE, name of the kind) for every kind in each list. */
#define FEATURE_OF_BSDF(name, FEATURE, PARAMETERS) KIND_FEATURE(FEATURE, #name)
#define FEATURE_OF_TEXTURE(name, FEATURE, OPERANDS) KIND_FEATURE(FEATURE, #name)
#define FEATURE_OF_CAMERA(name, FEATURE, CODE) KIND_FEATURE(FEATURE, #name)
#define FEATURE_OF_SHAPE(name, FEATURE, SPACE) KIND_FEATURE(FEATURE, #name)
#define FEATURE_OF_LIGHT(name, FEATURE, PLACE) KIND_FEATURE(FEATURE, #name)
#define FEATURE_OF_MEDIUM(name, FEATURE, VARIATION) KIND_FEATURE(FEATURE, #name)
/* Before use: #define KIND_FEATURE(FEATURE, text) ... */
#define KIND_FEATURES \
    BSDFS(FEATURE_OF_BSDF) SHAPES(FEATURE_OF_SHAPE) LIGHTS(FEATURE_OF_LIGHT) MEDIA_KINDS(FEATURE_OF_MEDIUM) \
    TEXTURES(FEATURE_OF_TEXTURE) TEXTURE_OPERATIONS(FEATURE_OF_TEXTURE) CAMERAS(FEATURE_OF_CAMERA)

#endif
