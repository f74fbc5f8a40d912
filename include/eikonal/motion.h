/* How things move while the shutter is open: between two affine maps, each taken apart into a stretching, a rotation and a translation
   (Shoemake and Duff 1992, "Matrix animation and polar decomposition"), which are interpolated one by one, as pbrt-v4 does. */
#ifndef EIKONAL_MOTION_H
#define EIKONAL_MOTION_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

typedef struct { float x, y, z, w; } quaternion;

/* At time t in [0, 1] (0: the start of the motion, 1: its end) point p is at
   lerp(start.xw, end.xw) + rotation(t) * lerp(start, end) * (p + centre), where only the nine coefficients of the maps stretch and
   their last column translates. */
typedef struct {
    affine start, end;
    quaternion start_rotation, end_rotation;   /* unit length, on the same side */
    float angle;                               /* between the quaternions, in [0, pi / 2]; 0: nothing turns */
    vec3 centre;                               /* for precision: big things that turn far from their origin */
} motion;

/* Times of camera rays: u in [0, 1) to `open + u * span`, clamped to [0, 1]. */
typedef struct { float open, span; } shutter;

CONTRACT_END
#endif
