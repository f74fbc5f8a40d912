/* Every kind of light. L(name, FEATURE, PLACE): a light called x is kernels/light/x.clh beside host/kinds/light/x.cpp.
   Each kind defines sample_x_light, and for paths that begin at the light sample_emission_x_light (kernels/light/arrival.clh). PLACE says
   what else:
     POINT      one point, which paths from the camera cannot hit: pdf_emission_x_light
     DISTANT    one direction, which they cannot hit either
     AREA       a shape, or one element of a mesh: pdf_x_light, for paths that hit it, and pdf_emission_x_light
     INFINITE   all directions: eval_x_light, for paths that leave the scene, and pdf_emission_x_light */
#ifndef EIKONAL_LIGHTS_H
#define EIKONAL_LIGHTS_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

#define LIGHTS(L) \
    L(point,            LIGHT_POINT,            POINT) \
    L(spot,             LIGHT_SPOT,             POINT) \
    L(distant,          LIGHT_DISTANT,          DISTANT) \
    L(triangle,         LIGHT_TRIANGLE,         AREA) \
    L(bilinear,         LIGHT_BILINEAR,         AREA) \
    L(sphere,           LIGHT_SPHERE,           AREA) \
    L(ellipsoid,        LIGHT_ELLIPSOID,        AREA) \
    L(disk,             LIGHT_DISK,             AREA) \
    L(cylinder,         LIGHT_CYLINDER,         AREA) \
    L(implicit,         LIGHT_IMPLICIT,         AREA) \
    L(goniometric,      LIGHT_GONIOMETRIC,      POINT) \
    L(projection,       LIGHT_PROJECTION,       POINT) \
    L(uniform_infinite, LIGHT_UNIFORM_INFINITE, INFINITE) \
    L(image_infinite,   LIGHT_IMAGE_INFINITE,   INFINITE) \
    L(portal_infinite,  LIGHT_PORTAL_INFINITE,  INFINITE)

#define LIGHT_KIND(name, FEATURE, PLACE) kind_##name##_light,
enum light_kind { LIGHTS(LIGHT_KIND) light_kinds };

CONTRACT_END
#endif
