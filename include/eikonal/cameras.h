/* Every kind of camera. C(name, FEATURE, CODE, RAYS): a camera called x is kernels/camera/x.clh, which defines generate_x
   (contract: kernels/camera/camera.clh), beside host/kinds/camera/x.cpp. CODE says how generate_x is built:
     STRAIGHT   straight-line code
     LOOPS      with loops, which keep the compiler from vectorising generate_rays in scenes with this camera
   RAYS says how the rays through one point of the lens lie, which decides how light paths are connected to the camera:
     CENTRAL    they go through a point, onto a plane
     PARALLEL   they are parallel
     AROUND     they go through a point, in all directions: the kind also defines image_area_x and wrap_screen_x
     TRACED     known only by tracing them through lenses, from both sides
   Every kind defines sample_importance_x (kernels/camera/importance.clh). */
#ifndef EIKONAL_CAMERAS_H
#define EIKONAL_CAMERAS_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

#define CAMERAS(C) \
    C(perspective,  CAMERA_PERSPECTIVE,  STRAIGHT, CENTRAL) \
    C(orthographic, CAMERA_ORTHOGRAPHIC, STRAIGHT, PARALLEL) \
    C(spherical,    CAMERA_SPHERICAL,    STRAIGHT, AROUND) \
    C(realistic,    CAMERA_REALISTIC,    LOOPS,    TRACED)

#define CAMERA_KIND(name, FEATURE, CODE, RAYS) camera_##name,
enum camera_kind { CAMERAS(CAMERA_KIND) camera_kinds };

CONTRACT_END
#endif
