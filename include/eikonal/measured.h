/* Measured BSDFs: how a file of the RGL database (Dupuy and Jakob 2018, "An Adaptive Parameterization for Efficient Material Acquisition and
   Rendering") lies in one table of floats, `measured_values`. All offsets are of elements of that table. */
#ifndef EIKONAL_MEASURED_H
#define EIKONAL_MEASURED_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

/* Values at the corners of (width - 1) x (height - 1) cells of the unit square, row by row; bilinear in between. */
typedef struct { uint first, width, height; } measured_grid;

/* A grid for each direction wo, as a density over the unit square, with the integrals from which it is sampled. */
typedef struct {
    measured_grid density;
    uint marginal;       /* height values: the integral up to each row */
    uint conditional;    /* width x height: the integral of each row up to each column */
} measured_warp;

typedef struct {
    uint phi_count, theta_count;   /* directions wo for which there are values: all pairs, theta inner */
    uint phis, thetas;             /* their angles, ascending */
    uint isotropic;                /* azimuths of facets are relative to wo's */
    measured_grid facets;          /* distribution of facet normals, by (theta, phi) in their square */
    measured_grid area;            /* projected area of facets, by wo in its square */
    measured_warp visible;         /* facet normals that wo sees */
    measured_warp brightness;      /* of the reflected light, over the square that `visible` warps to facets */
    measured_grid color;           /* the reflected light there: for each wo three grids, red, green and blue */
} measured;

CONTRACT_END
#endif
