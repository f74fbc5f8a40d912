/* The acceleration structure: a BVH with eight children per node, so that one SIMD register tests all of them. */
#ifndef EIKONAL_BVH_H
#define EIKONAL_BVH_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

#define BVH_WIDTH 8

/* The most nodes on a path from the root to a leaf, for the world and for each instanced object; the builder goes no deeper. */
#define BVH_MAX_DEPTH 18

/* How far planes of boxes move outwards for rounding errors, relative to the largest coordinate: of the box when it is built, of the ray's
   origin when it is tested. 16 roundings (host/bvh/padding.h). */
#define BOX_PADDING 0x1p-20f

/* child[i]: an inner node (its index), or a leaf (kind, count and first packed, see below); NONE: no child (its box is empty).
   SoA bounds: bounds[0..5] = x low, x high, y low, y high, z low, z high, of eight children each.
   order[o]: the children as rays of octant o should visit them, the last one first: eight numbers of children, four bits each, from the
   lowest on. Bit a of o: the rays run down axis a. */
typedef struct {
    float bounds[6][BVH_WIDTH];
    uint child[BVH_WIDTH];
    uint order[BVH_WIDTH];
} bvh_node;

/* A leaf reference: bit 31 set, kind (enum leaf_kind) in bits 29-30, count - 1 in bits 26-28, first in bits 0-25:
   leaf_triangles: first line in `triangle_lines`; leaf_elements: first of `count` words in `leaf_elements`; leaf_instances: the instance
   itself. */
#define LEAF_BIT         0x80000000u
#define LEAF_KIND_SHIFT  29
#define LEAF_KIND_MASK   3u
#define LEAF_COUNT_SHIFT 26
#define LEAF_COUNT_MASK  7u
#define LEAF_FIRST_MASK  0x03ffffffu
enum leaf_kind { leaf_triangles, leaf_elements, leaf_instances };

/* The triangles of a leaf are tested together and fill as many cache lines as needed: of n triangles, number i has coordinate c of corner v
   in word (3 v + c) n + i and its element in word 9 n + i. A load of eight words from any of these rows stays within the leaf's lines. */
#define TRIANGLE_WORDS 10
typedef struct { float words[16]; } triangle_line;
/* Set in element words. SIMD loads also read these words as coordinates, in lanes that are masked out; without the mark, small integers
   would be denormals, which are slow. */
#define ELEMENT_MARK 0x40000000u

CONTRACT_END
#endif
