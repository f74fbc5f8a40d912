/* Every kind of camera. C(name, FEATURE, CODE): a camera called x is kernels/camera/x.clh, which defines generate_x
   (contract: kernels/camera/camera.clh), beside host/kinds/camera/x.cpp. CODE says how generate_x is built:
     STRAIGHT   straight-line code
     LOOPS      with loops, which keep the compiler from vectorising generate_rays in scenes with this camera */
#ifndef EIKONAL_CAMERAS_H
#define EIKONAL_CAMERAS_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

#define CAMERAS(C) \
    C(perspective,  CAMERA_PERSPECTIVE,  STRAIGHT) \
    C(orthographic, CAMERA_ORTHOGRAPHIC, STRAIGHT) \
    C(spherical,    CAMERA_SPHERICAL,    STRAIGHT) \
    C(realistic,    CAMERA_REALISTIC,    LOOPS)

#define CAMERA_KIND(name, FEATURE, CODE) camera_##name,
enum camera_kind { CAMERAS(CAMERA_KIND) camera_kinds };

CONTRACT_END
#endif
