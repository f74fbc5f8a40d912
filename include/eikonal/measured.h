/* Measured BSDFs: layout of a file of the RGL database (Dupuy and Jakob 2018, "An Adaptive Parameterization for Efficient Material
   Acquisition and Rendering") in one table of floats, `measured_values`. All offsets count elements of that table. */
#ifndef EIKONAL_MEASURED_H
#define EIKONAL_MEASURED_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

/* Values at the corners of (width - 1) x (height - 1) cells of the unit square, row by row, interpolated bilinearly. */
typedef struct { uint first, width, height; } measured_grid;

/* One grid per direction wo, a density over the unit square, with the integrals for sampling it. */
typedef struct {
    measured_grid density;
    uint marginal;       /* height values: integral up to each row */
    uint conditional;    /* width x height values: integral of each row up to each column */
} measured_warp;

typedef struct {
    uint phi_count, theta_count;   /* the measured directions wo are all pairs of angles, theta fastest */
    uint phis, thetas;             /* the angles, ascending */
    uint isotropic;                /* 1: azimuths of microfacets are relative to wo's */
    measured_grid facets;          /* distribution of microfacet normals (NDF), by (theta, phi) in the unit square */
    measured_grid area;            /* projected microfacet area, by wo in the unit square */
    measured_warp visible;         /* distribution of visible microfacet normals */
    measured_warp brightness;      /* luminance of the reflected light, over the square that `visible` warps to microfacet normals */
    measured_grid color;           /* colour of the reflected light, over the same square: three grids per wo, red, green and blue */
} measured;

CONTRACT_END
#endif
