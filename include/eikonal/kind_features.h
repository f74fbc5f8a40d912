/* The features of kinds: each line of a family's list names one. */
#ifndef EIKONAL_KIND_FEATURES_H
#define EIKONAL_KIND_FEATURES_H
#include "eikonal/bsdfs.h"
#include "eikonal/cameras.h"
#include "eikonal/lights.h"
#include "eikonal/media.h"
#include "eikonal/shapes.h"
#include "eikonal/textures.h"

/* KIND_FEATURES calls KIND_FEATURE(FEATURE, name of the kind) for every kind in each list. */
#define FEATURE_OF_BSDF(name, FEATURE, PARAMETERS) KIND_FEATURE(FEATURE, #name)
#define FEATURE_OF_TEXTURE(name, FEATURE, OPERANDS) KIND_FEATURE(FEATURE, #name)
#define FEATURE_OF_CAMERA(name, FEATURE, CODE, RAYS) KIND_FEATURE(FEATURE, #name)
#define FEATURE_OF_SHAPE(name, FEATURE, SPACE) KIND_FEATURE(FEATURE, #name)
#define FEATURE_OF_LIGHT(name, FEATURE, PLACE) KIND_FEATURE(FEATURE, #name)
#define FEATURE_OF_MEDIUM(name, FEATURE, VARIATION) KIND_FEATURE(FEATURE, #name)
/* Before use: #define KIND_FEATURE(FEATURE, text) ... */
#define KIND_FEATURES \
    BSDFS(FEATURE_OF_BSDF) SHAPES(FEATURE_OF_SHAPE) LIGHTS(FEATURE_OF_LIGHT) MEDIA_KINDS(FEATURE_OF_MEDIUM) \
    TEXTURES(FEATURE_OF_TEXTURE) TEXTURE_OPERATIONS(FEATURE_OF_TEXTURE) CAMERAS(FEATURE_OF_CAMERA)

#endif
