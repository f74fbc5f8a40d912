/* Every kind of participating medium. M(name, FEATURE, VARIATION): medium x is kernels/medium/x.clh beside host/kinds/medium/x.cpp.
   VARIATION says how its coefficients vary, and with that what x.clh defines:
     HOMOGENEOUS     not at all: nothing; kernels/medium/homogeneous.clh samples all of them
     HETEROGENEOUS   from point to point of a box: eval_x_medium and bounded_x_medium (kernels/medium/null_collision.clh). If they are
                     trilinear between the points of a grid, x.cpp sets medium.has_cells */
#ifndef EIKONAL_MEDIA_H
#define EIKONAL_MEDIA_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

#define MEDIA_KINDS(M) \
    M(homogeneous, MEDIUM_HOMOGENEOUS, HOMOGENEOUS) \
    M(uniformgrid, MEDIUM_UNIFORMGRID, HETEROGENEOUS)  /* density on a regular grid */ \
    M(rgbgrid,     MEDIUM_RGBGRID,     HETEROGENEOUS)  /* coefficients on a regular grid */ \
    M(cloud,       MEDIUM_CLOUD,       HETEROGENEOUS)  /* density from noise */ \
    M(nanovdb,     MEDIUM_NANOVDB,     HETEROGENEOUS)  /* density on a sparse grid */

#define MEDIUM_KIND(name, FEATURE, VARIATION) kind_##name##_medium,
enum medium_kind { MEDIA_KINDS(MEDIUM_KIND) medium_kinds };

CONTRACT_END
#endif
