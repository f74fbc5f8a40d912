/* Every camera.   C(name, FEATURE).  A camera called x is kernels/camera/x.clh, which defines generate_x. */
#ifndef EIKONAL_CAMERAS_H
#define EIKONAL_CAMERAS_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

#define CAMERAS(C) \
    C(perspective,  CAMERA_PERSPECTIVE) \
    C(orthographic, CAMERA_ORTHOGRAPHIC)

#define CAMERA_KIND(name, FEATURE) camera_##name,
enum camera_kind { CAMERAS(CAMERA_KIND) camera_kinds };

/* A film plane in front of the eye. Screen x runs to the right and y up; camera space looks along +z. */
typedef struct {
    uint kind;                     /* enum camera_kind */
    affine scene_from_camera;
    float screen_x, screen_y;      /* screen coordinates of the upper left corner of pixel (0, 0) */
    float step_x, step_y;          /* screen coordinates from one pixel to the next; step_y < 0 */
    float lens_radius;             /* in camera space; 0: a pinhole */
    float focal_distance;          /* along z, camera space */
    uint medium;                   /* around the camera, or NONE */
} camera;

/* A reconstruction filter, separable, sampled by importance: a piecewise-constant density over FILTER_CELLS cells of one
   axis as an alias table (in `filter_aliases`: x, then y), and the filter's value over that density. */
#define FILTER_CELLS 64
typedef struct {
    float radius_x, radius_y;      /* pixels */
} filter;

CONTRACT_END
#endif
