/* Every shape. An element is what the acceleration structure stores: one triangle, bilinear patch, quadric, piece of a curve segment or
   implicit surface. Elements are numbered through the whole scene, shape after shape.
   S(name, FEATURE, SPACE): a shape called x is kernels/shape/x.clh beside host/kinds/shape/x.cpp. SPACE says in which space its elements
   are:
     OBJECT   object space, whose maps are in `object_spaces`: one element for a shape
     GROUP    the space of the BVH that holds them
     LEAF     as GROUP; the BVH has leaves of their own for them, eight side by side
   kernels/shape/shapes.clh says what x.clh defines for each. */
#ifndef EIKONAL_SHAPES_H
#define EIKONAL_SHAPES_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

#define SHAPES(S) \
    S(triangle, SHAPE_TRIANGLE, LEAF) \
    S(bilinear, SHAPE_BILINEAR, GROUP) \
    S(sphere,   SHAPE_SPHERE,   OBJECT) \
    S(disk,     SHAPE_DISK,     OBJECT) \
    S(cylinder, SHAPE_CYLINDER, OBJECT) \
    S(curve,    SHAPE_CURVE,    GROUP) \
    S(implicit, SHAPE_IMPLICIT, OBJECT)

#define SHAPE_KIND(name, FEATURE, SPACE) shape_##name,
enum shape_kind { SHAPES(SHAPE_KIND) shape_kinds };

CONTRACT_END
#endif
