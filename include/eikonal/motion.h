/* Motion while the shutter is open: interpolation between two affine maps, each decomposed into stretch, rotation and translation
   (Shoemake and Duff 1992, "Matrix animation and polar decomposition"), which are interpolated separately, as in pbrt-v4. */
#ifndef EIKONAL_MOTION_H
#define EIKONAL_MOTION_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

typedef struct { float x, y, z, w; } quaternion;

/* At time t in [0, 1] (0: start of the motion, 1: its end) point p moves to
   lerp(start.xw, end.xw) + rotation(t) * lerp(start, end) * (p + centre). Only the nine coefficients of the maps take part in the stretch;
   their last column is the translation. */
typedef struct {
    affine start, end;
    quaternion start_rotation, end_rotation;   /* unit length, with a nonnegative dot product */
    float angle;                               /* between the quaternions, in [0, pi / 2]; 0: no rotation */
    vec3 centre;                               /* offset that keeps precision when large objects rotate far from their origin */
} motion;

/* Maps u in [0, 1) to the time of a camera ray: `open + u * span`, clamped to [0, 1]. */
typedef struct {
    float open, span;
    uint is_shared;      /* 1: more than the camera moves, so paths that merge or connect need the same time, one for each pass */
} shutter;

CONTRACT_END
#endif
