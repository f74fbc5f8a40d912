/* Every participating medium.   M(name, FEATURE).  A medium called x is kernels/medium/x.clh. */
#ifndef EIKONAL_MEDIA_H
#define EIKONAL_MEDIA_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

#define MEDIA_KINDS(M) \
    M(homogeneous_medium,  MEDIUM_HOMOGENEOUS) \
    M(uniformgrid_medium,  MEDIUM_UNIFORMGRID)

#define MEDIUM_KIND(name, FEATURE) kind_##name,
enum medium_kind { MEDIA_KINDS(MEDIUM_KIND) medium_kinds };

/* Cells along a side of the coarse grid of density bounds that a heterogeneous medium is tracked through. */
#define MAJORANT_CELLS 16

typedef struct {
    uint kind;                 /* enum medium_kind */
    color sigma_a, sigma_s;    /* per unit of scene space; a grid's density multiplies them */
    color Le;                  /* emitted radiance per unit of sigma_a */
    float g;                   /* Henyey-Greenstein: mean cosine, in [-0.99, 0.99] */
    affine grid_from_scene;    /* grids: the unit cube is the grid */
    uint nx, ny, nz;           /* grids: samples along each side */
    uint first_density;        /* in `densities`: nx*ny*nz values, x fastest */
    uint first_Le;             /* in `densities`: a scale of Le, one value a sample; NONE: 1 */
    uint first_majorant;       /* in `majorants`: MAJORANT_CELLS^3 values, x fastest */
} medium;

CONTRACT_END
#endif
