/* Every camera.   C(name, FEATURE).  A camera called x is kernels/camera/x.clh, which defines generate_x. One that is not
   straight-line (realistic: a loop over lens elements) keeps generate_rays from being widened, in scenes that have it. */
#ifndef EIKONAL_CAMERAS_H
#define EIKONAL_CAMERAS_H
#include "eikonal/motion.h"
#include "eikonal/portable.h"
CONTRACT_BEGIN

#define CAMERAS(C) \
    C(perspective,  CAMERA_PERSPECTIVE) \
    C(orthographic, CAMERA_ORTHOGRAPHIC) \
    C(spherical,    CAMERA_SPHERICAL) \
    C(realistic,    CAMERA_REALISTIC)

#define CAMERA_KIND(name, FEATURE) camera_##name,
enum camera_kind { CAMERAS(CAMERA_KIND) camera_kinds };

/* Intervals of the distance from the film's centre, from 0 to half its diagonal, for each of which the exit pupil is bounded. */
#define PUPIL_INTERVALS 64

/* One interface of a realistic lens, as rays from the film meet it. The film lies at z = 0, +z points to the scene; metres. */
typedef struct {
    float z;                       /* of its vertex */
    float radius;                  /* of curvature, as rays from the scene see it: > 0 is convex; 0: the aperture stop */
    float aperture;                /* its half diameter */
    float eta;                     /* index on the side of the scene over index on the side of the film */
} lens_element;

/* Where on the plane of the last lens light comes from that reaches film points in one interval: a rectangle, for a film point on
   the positive x axis. Empty if low_x > high_x. Metres. */
typedef struct { float low_x, low_y, high_x, high_y; } pupil_bounds;

/* A film plane in front of the eye. Screen x runs to the right and y up; camera space looks along +z. What "screen" is:
     perspective   the plane z = 1        orthographic   the plane z = 0        spherical   the unit square of its mapping, y down
     realistic     the film itself, upside down and mirrored as a lens makes it, metres */
typedef struct {
    uint kind;                     /* enum camera_kind */
    affine scene_from_camera;      /* of a camera that moves: where it is when the motion starts */
    motion moving;                 /* scene from camera; only with CAMERA_MOTION */
    shutter times;
    float screen_x, screen_y;      /* screen coordinates of the upper left corner of pixel (0, 0) */
    float step_x, step_y;          /* screen coordinates from one pixel to the next; step_y < 0 */
    float lens_radius;             /* in camera space; 0: a pinhole */
    float focal_distance;          /* along z, camera space */
    uint equal_area;               /* spherical: 1: equal-area mapping (Clarberg 2008), 0: longitude and latitude */
    uint element_count;            /* realistic: in `lens_elements`, from the film to the scene */
    float rear_z;                  /* realistic: vertex of the element next to the film, metres */
    float film_radius;             /* realistic: half the film's diagonal, metres */
    uint aperture_width, aperture_height; /* realistic: texels in `aperture_texels`; 0: the stop is round */
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
