/* A camera as kernels see it, its lens and its pixel filter. Its kinds: cameras.h. */
#ifndef EIKONAL_CAMERA_H
#define EIKONAL_CAMERA_H
#include "eikonal/motion.h"
#include "eikonal/portable.h"
CONTRACT_BEGIN

/* Number of film intervals with their own exit-pupil bounds; they divide the distance from the film's centre to its corner. */
#define PUPIL_INTERVALS 64

/* One interface of a realistic lens, in the order of rays from the film. The film is at z = 0, +z points to the scene; camera space. */
typedef struct {
    float z;                       /* z of its vertex */
    float radius;                  /* of curvature, for rays from the scene: > 0 is convex; 0: the aperture stop */
    float aperture;                /* half its diameter */
    float eta;                     /* index on the scene side over index on the film side */
} lens_element;

/* The exit pupil seen from the film points of one interval, for points on the positive x axis: a rectangle on the plane of the rear lens
   element. Empty if low_x > high_x. Camera space. */
typedef struct { float low_x, low_y, high_x, high_y; } pupil_bounds;

/* A film plane in front of the eye. Screen x points right and y up; camera space looks along +z, and its unit is about that of scene
   space (host/pack/camera.h). Screen space by kind:
     perspective   the plane z = 1        orthographic   the plane z = 0        spherical   the unit square of its mapping, y down
     realistic     the film itself, whose image is upside down and mirrored, camera space */
typedef struct {
    uint kind;                     /* enum camera_kind */
    affine scene_from_camera;      /* of a moving camera: at the start of all motion */
    motion moving;                 /* scene from camera; only with CAMERA_MOTION */
    shutter times;
    float screen_x, screen_y;      /* screen coordinates of the upper left corner of pixel (0, 0) */
    float step_x, step_y;          /* screen distance between neighbouring pixels; step_y < 0 */
    float lens_radius;             /* camera space; 0: pinhole; realistic: of the disk through which rays leave the lens */
    float front_z;                 /* where the points of the lens are; realistic: in front of its glass; all others: 0 */
    float focal_distance;          /* along z, camera space */
    uint equal_area;               /* spherical: 1: equal-area mapping (Clarberg 2008), 0: equirectangular mapping */
    uint element_count;            /* realistic: in `lens_elements`, from film to scene */
    float rear_z;                  /* realistic: vertex of the rear element, camera space */
    float film_radius;             /* realistic: half the film's diagonal, camera space */
    uint aperture_width, aperture_height; /* realistic: size of the image in `aperture_texels`; 0: a round stop */
    uint is_parallel;              /* 1: rays through one point of the lens are parallel (PARALLEL in cameras.h) */
    uint is_around;                /* 1: they go in all directions (AROUND) */
    uint medium;                   /* medium around the camera, or NONE */
} camera;

/* A separable reconstruction filter, importance-sampled from a piecewise-constant density: cells of equal width per axis as an alias table
   (in `filter_aliases`: x, then y), and the filter's value over that density (in `filter_values`). */
#define MOST_FILTER_CELLS 4096
typedef struct {
    float radius_x, radius_y;      /* pixels */
    uint cells;                    /* per axis; a power of two */
    float mean;                    /* its integral, where that of its absolute value is 1 */
} filter;

CONTRACT_END
#endif
