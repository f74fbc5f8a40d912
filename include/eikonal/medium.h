/* A participating medium as kernels see it, its grids, and what media need of lights. Its kinds: media.h. */
#ifndef EIKONAL_MEDIUM_H
#define EIKONAL_MEDIUM_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

/* Bricks of a grid have this many cells a side, and hold the values at all of their corners: one more, which neighbours hold as well.
   So a lookup reads one brick. */
#define BRICK_CELLS 8
#define BRICK_SIDE (BRICK_CELLS + 1)
#define BRICK_VALUES (BRICK_SIDE * BRICK_SIDE * BRICK_SIDE)

/* Numbers on a grid of any size, mostly empty or not: bricks that are the same number everywhere are stored once. */
typedef struct {
    affine cell_from_box;      /* from the medium's unit cube to where whole numbers are the corners of cells; the first corner is 0 */
    uint bricks_x, bricks_y, bricks_z;
    uint first_brick;          /* in `bricks`, x fastest: which brick of `brick_values` */
} grid;

/* The colours of black bodies, tabulated by the logarithm of their temperature. */
#define BLACKBODY_COLDEST 100.0f      /* K; at and below, no emission (as in pbrt-v4) */
#define BLACKBODY_HOTTEST 1e6f
#define BLACKBODY_STEPS 1024
typedef struct {
    float log_brightness;      /* of the luminance of a black body whose greatest spectral radiance is 1 */
    float red, green, blue;    /* of luminance 1, linear sRGB */
} blackbody_color;

/* A point light: its light falls off with the squared distance, so equiangular sampling is used for it. */
typedef struct {
    vec3 p;
    float share;               /* probability of being the one that is chosen */
} point_light_position;
#define MOST_EQUIANGULAR_LIGHTS 8

/* Subsurface bodies in one another: a path remembers the media around this many, by 16 bits each (kernels/shade/bodies.clh). */
#define MOST_NESTED_BODIES 6u
#define NO_BODY_MEDIUM 0xffffu   /* NONE in 16 bits; media have smaller numbers */

typedef struct {
    uint kind;                 /* enum medium_kind */
    color sigma_a, sigma_s;    /* per unit of scene space; grids and noise multiply them */
    color Le;                  /* emitted radiance per unit of sigma_a; grids multiply it */
    uint scatters;             /* 0: sigma_s is 0 everywhere, for every wavelength */
    float g;                   /* Henyey-Greenstein: mean cosine, in [-0.99, 0.99] */
    uint equiangular_lights;   /* homogeneous ones that scatter: how many of `point_lights` there are; 0: none, or none that matters */

    /* HETEROGENEOUS: the medium fills its unit cube */
    affine box_from_scene;     /* of one that moves: from the medium's space instead */
    uint motion;               /* in `medium_motions`; NONE: it does not move */
    uint majorants_x, majorants_y, majorants_z;
    uint first_majorant;       /* in `majorants`, x fastest: bounds, over the cells of a coarse grid, on what multiplies sigma_t */

    affine cells_from_box;     /* from the unit cube to where whole numbers bound cells; sigma_a and sigma_s are trilinear in each */
    uint has_cells;            /* 0: they are not trilinear */

    /* uniformgrid, nanovdb: in `grids`, or NONE */
    uint density;
    uint temperature;          /* black bodies of (temperature - offset) * scale kelvin shine, times Le; NONE: Le does */
    uint Le_scale;             /* multiplies Le; NONE: 1 */
    float temperature_offset, temperature_scale;

    /* rgbgrid: in `medium_colors`, nx*ny*nz of each, x fastest, in the middle of their cells; NONE: 1, of Le: 0 */
    uint nx, ny, nz;
    uint first_sigma_a, first_sigma_s, first_Le;

    /* cloud: noise is a function of the medium's own space, in which low and extent are the unit cube's */
    vec3 low, extent;
    float noise_density, wispiness, frequency;
} medium;

CONTRACT_END
#endif
