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

/* A leaf reference: bit 31 set, kind (enum leaf_kind) in bits 29-30, count - 1 in bits 26-28, first in bits 0-25:
   of triangle leaves, the first of their lines in `triangle_lines`; of others, of a run of `count` words in `leaf_elements`. */
#define LEAF_BIT         0x80000000u
#define LEAF_KIND_SHIFT  29
#define LEAF_KIND_MASK   3u
#define LEAF_COUNT_SHIFT 26
#define LEAF_COUNT_MASK  7u
#define LEAF_FIRST_MASK  0x03ffffffu
enum leaf_kind { leaf_triangles, leaf_elements, leaf_instances };

/* The triangles of a leaf are tested at once, and fill as many lines of a cache as they need: of n triangles, i has coordinate c of corner v
   in word (3 v + c) n + i and its element in word 9 n + i. A load of eight words from any of these rows stays in their lines. */
#define TRIANGLE_WORDS 10
typedef struct { float words[16]; } triangle_line;
/* Set in the word of an element, for the sake of lanes that load it as a coordinate and whose results nobody wants: small whole numbers
   would be denormal, and slow. */
#define ELEMENT_MARK 0x40000000u

CONTRACT_END
#endif
