/* The acceleration structure: a hierarchy of boxes with eight children a node, so that one SIMD register tests all eight. */
#ifndef EIKONAL_BVH_H
#define EIKONAL_BVH_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

#define BVH_WIDTH 8

/* Nodes on the longest way down, for the world and for each object that is instanced: the builder goes no deeper. */
#define BVH_MAX_DEPTH 18

/* child[i]: an inner node (its index), or a leaf: kind, count and first packed, see below; NONE: no child (its box is empty).
   The planes lie side by side: bounds[0..5] = x low, x high, y low, y high, z low, z high, eight children each. */
typedef struct {
    float bounds[6][BVH_WIDTH];
    uint child[BVH_WIDTH];
} bvh_node;

/* A leaf reference: bit 31 set, kind (enum leaf_kind) in bits 28-30, count - 1 in bits 25-27, first in bits 0-24:
   triangle leaves: `first` numbers a triangle_block; others: a run of `count` words in `leaf_elements`. */
#define LEAF_BIT         0x80000000u
#define LEAF_KIND_SHIFT  28
#define LEAF_COUNT_SHIFT 25
#define LEAF_FIRST_MASK  0x01ffffffu
enum leaf_kind { leaf_triangles, leaf_elements, leaf_instances };

/* Eight triangles or fewer, tested at once: vertex v, coordinate c is corner[3 v + c]. Unused lanes: element NONE, all corners equal. */
typedef struct {
    float corner[9][BVH_WIDTH];
    uint element[BVH_WIDTH];
} triangle_block;

CONTRACT_END
#endif
