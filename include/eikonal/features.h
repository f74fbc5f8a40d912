/* What a scene may require besides kinds, whose features are in kind_features.h. On the device a feature X is the macro HAS_X, 0 or 1, and
   code tests `if (HAS_X)`; on the host it is a bit of `Features` (host/feature_set.h). A kernel's program is built with only those features
   that its source mentions, so scenes can share binaries.   F(NAME, what requires it) */
#ifndef EIKONAL_FEATURES_H
#define EIKONAL_FEATURES_H

#define GENERAL_FEATURES(F) \
    F(SPECTRAL,         "rendering at wavelengths instead of in RGB") \
    F(SPECTRAL_FILM,    "a film that keeps a spectrum of each pixel") \
    F(DISPERSION,       "an index of refraction that depends on the wavelength") \
    F(MEDIA,            "a participating medium") \
    F(SUBSURFACE,       "subsurface scattering") \
    F(DIFFUSION,        "a subsurface body with a diffusion profile") \
    F(BODY_TEXTURES,    "a subsurface body with textured coefficients") \
    F(EQUIANGULAR,      "a point light and a homogeneous medium that scatters") \
    F(INTERFACE,        "a surface of material \"interface\"") \
    F(INSTANCES,        "object instances") \
    F(STRIPS,           "a curve: its rays begin a width away") \
    F(ALPHA,            "shapes cut out by an alpha texture") \
    F(MIX,              "a mix of materials") \
    F(LAYERS,           "a coat over a base") \
    F(LAYER_MEDIUM,     "a coat with a medium between it and its base") \
    F(TEXTURED,         "a material parameter that varies over its surface") \
    F(TRANSMISSION,     "a material that transmits") \
    F(ANISOTROPY,       "an anisotropic material") \
    F(TANGENTS,         "a mesh with tangents") \
    F(GRAIN,            "an anisotropic measured material") \
    F(BUMP,             "a displacement texture") \
    F(NORMAL_MAP,       "a normal map") \
    F(EMITTERS,         "a surface that emits") \
    F(LIGHT_PATTERN,    "an area light with an image, or cut out by an alpha texture") \
    F(LIGHTS,           "a light that can be sampled") \
    F(LIGHT_TREE,       "many lights, or \"lightsampler\" \"bvh\"") \
    F(ENVIRONMENT_GUIDE, "a constant infinite light, sampled where surfaces see it") \
    F(PATH_GUIDE,       "paths that learn where light comes from") \
    F(PORTALS,          "an infinite light with a portal") \
    F(LENS,             "a lens with an aperture") \
    F(APERTURE,         "an aperture that is not round") \
    F(IMPORTANCE,       "a film that receives more light through some rays than through others") \
    F(MOTION,           "a shape that moves") \
    F(MEDIUM_MOTION,    "a medium that moves") \
    F(CAMERA_MOTION,    "a camera that moves") \
    F(FILTER,           "a pixel filter other than a box of one pixel") \
    F(SOBOL,            "a low-discrepancy sampler") \
    F(JOINT_PAIRS,      "a sampler that spreads pairs of numbers together") \
    F(REGULARIZE,       "an integrator that regularizes") \
    F(FORCE_DIFFUSE,    "option \"forcediffuse\"") \
    F(AMBIENT_OCCLUSION, "integrator \"ambientocclusion\"") \
    F(RAY_SPLITTING,    "an integrator that splits rays") \
    F(UNIFORM_DIRECTIONS, "an integrator that samples directions uniformly") \
    F(LIGHT_PATHS,      "an integrator that traces paths from lights") \
    F(CONNECTIONS,      "an integrator that connects vertices of paths from both ends") \
    F(MERGING,          "an integrator that merges vertices of paths from both ends") \
    F(AOVS,             "auxiliary image channels") \
    F(RENDER_PASSES,    "the channels \"emission\", \"direct\", \"indirect\" and \"volume\"") \
    F(LIGHT_GROUPS,     "the channels of light groups") \
    F(FIREFLIES,        "a film that keeps light by the brightness of samples") \
    F(CRYPTO_OBJECT,    "the channels \"CryptoObject\"") \
    F(CRYPTO_MATERIAL,  "the channels \"CryptoMaterial\"") \
    F(MOTION_VECTORS,   "the channel \"motion\", and a shape that moves") \
    F(CAMERA_SPACE,     "channels in the space of a camera that moves")

#endif
