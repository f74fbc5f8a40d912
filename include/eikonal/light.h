/* A light as kernels see it, and the tables that light samples use. Its kinds: lights.h. */
#ifndef EIKONAL_LIGHT_H
#define EIKONAL_LIGHT_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

/* One light, whatever its kind: a straight-line kernel reads the same words for all. Which are meaningful:
     point        p, L (intensity)
     spot         p, n (axis), cos_inner, cos_outer, L (intensity on the axis)
     distant      n (towards the light), L (irradiance on a surface that faces it), extent (how far its light comes through a medium
                  around the scene: the diameter of a sphere around all that is in it, as in pbrt-v4); as of all lights that are infinitely
                  far away but those with a portal, with LIGHT_PATHS: p, radius (a sphere around the scene)
     triangle     p, a, b (edges from p), n, inverse_area, L
     bilinear     p, a, b, c (point(u, v) = p + u a + v b + u v c), n (in the middle), extent (1: emits on the side of du x dv, or -1), L
     sphere       p (centre), radius, inverse_area, n.x (1: emits outwards, -1: inwards), L
     ellipsoid    p (centre), a, b, c (half axes), extent, cos_inner, cos_outer (the part of the axis c, in [-1, 1]), n.x (the side that
                  emits: 1 that of dp/dphi x dp/dz, or -1), inverse_area (of all of it), L; a part of a sphere is one, too
     disk         p (centre), a, b (radii: point = p + x a + y b), radius (of its hole, 1: all of it), extent, n, inverse_area, L
     cylinder     p (centre of the end at z_min), a, b (radii), c (axis: point = p + cos a + sin b + v c), extent, n.x (the side that
                  emits: 1 that of dp/dphi x c, or -1), inverse_area (of all of it), L
     implicit     p (centre) and radius of a sphere around it, inverse_area (an estimate), L
     goniometric  p, a, b, n (rows of image-from-scene), first_texel, resolution, L (intensity where the image is 1)
     projection   p, a, b, n (rows of image-from-scene: the slide fills |x / z| <= 1, |y / z| <= 1), first_texel, resolution,
                   rows, L (intensity)
     uniform_infinite   L
     image_infinite     a, b, n (rows of light-from-scene), first_texel, first_alias, resolution, L (scale)
     portal_infinite    p, c (opposite corners), a, b, n (its sides and the normal that points out), first_texel, first_sum,
                   resolution, L (scale)
   Areas emit on the side of n (implicit ones: of their gradient), on both with `two_sided`. */
#define LIGHT_FIELDS(F) \
    F(uint,     kind)         /* enum light_kind */ \
    F(uint,     two_sided)    /* 0 or 1 */ \
    F(uint,     element)      /* of an area; otherwise NONE */ \
    F(uint,     has_pattern)  /* 1: an area of varying radiance (an image, alpha). L is the mean, without alpha */ \
    F(uint,     invisible)    /* 1: an area that no ray hits, since its alpha is 0: only light sampling finds it */ \
    F(uint,     group)        /* its light group: 0 is "default" */ \
    F(uint,     medium)       /* LIGHT_PATHS: the medium around it, or NONE; of areas whose shape has an interface, that counts */ \
    F(float,    emission_pmf) /* LIGHT_PATHS: probability that a light path begins here */ \
    F(float,    pmf)          /* probability of being sampled, or that of the tree that it is in; 0: only BSDF sampling finds it */ \
    F(float,    inverse_area) \
    F(float,    rounding)     /* areas: distance, along the normal, by which rounding may move a sampled point off the surface */ \
    F(float,    extent)       /* ellipsoid, disk, cylinder: how much of the circle there is, in (0, 1]; distant: a length */ \
    F(vec3,     p) \
    F(vec3,     a) \
    F(vec3,     b) \
    F(vec3,     c) \
    F(vec3,     n) \
    F(float,    radius) \
    F(float,    cos_inner) \
    F(float,    cos_outer) \
    F(color,    L) \
    F(uint,     first_texel)  /* in `environment_texels`: resolution^2 texels */ \
    F(uint,     first_alias)  /* in `environment_aliases`: one entry a row, then the entries of each row */ \
    F(uint,     resolution)   /* texels on a side of the square; 1 for other kinds, which straight-line code looks up as well */ \
    F(uint,     rows)         /* projection: texels in a column, of `resolution` columns; 1 for other kinds */ \
    F(uint,     first_sum)    /* portal: in `portal_sums`: (resolution + 1)^2 of them */ \
    F(uint,     leaf)         /* in the light tree: node * LIGHT_TREE_WIDTH + child; NONE: not in it */

#define LIGHT_MEMBER(type, name) type name;
typedef struct { LIGHT_FIELDS(LIGHT_MEMBER) } light;

/* The light group of lights that name none. */
#define DEFAULT_GROUP 0u

/* Of several lights to choose from, each weight is raised to at least this share of the mean weight; its probability is then at least 1/21
   of that under uniform choice. */
#define LEAST_SHARE 0.05f

/* An entry of an alias table (Vose 1991): keep this one with probability `keep`, else take `other`. */
typedef struct {
    float keep;
    uint other;
    float pmf;           /* of this entry, to evaluate its density */
} alias_entry;

/* The environment guide: where the light of a uniform environment enters the scene, and how much of it each surface receives.

   A box encloses what paths reach. Rectangles on its sides, the openings, are where rays leave it without meeting a surface; there are
   GUIDE_OPENINGS of them, smaller where more rays leave. Space is cut into GUIDE_INTERVALS^3 cells; each cell has GUIDE_FACES
   maps: for surfaces whose normal is nearest to +x, -x, +y, -y, +z, -z, and for points that look into all directions. A map has a
   probability for each opening, in units of one in GUIDE_UNITS: it consists of the sums of those of the openings before each. GUIDE_SIDE
   openings are a row. First come the sums before each row, then those before each opening, two in a word, the lower half first; so a map is
   in few cache lines. The map of a place that sees no opening has GUIDE_UNITS everywhere: density 0. */
#define GUIDE_INTERVALS 16
#define GUIDE_FACES 7
#define GUIDE_ALL_DIRECTIONS 6
#define GUIDE_SIDE 8
#define GUIDE_OPENINGS (GUIDE_SIDE * GUIDE_SIDE)
#define GUIDE_MAP_WORDS ((GUIDE_SIDE + GUIDE_OPENINGS) / 2)
#define GUIDE_UNITS 65535

/* Each side of the box is cut into GUIDE_TEXELS^2 texels: side 2 axis + (0 the low one, 1 the high one), then rows along the later of the
   other two axes. */
#define GUIDE_TEXELS 64
#define GUIDE_BOX_TEXELS (6 * GUIDE_TEXELS * GUIDE_TEXELS)

/* A rectangle on a side of the box: points corner + x a + y b, with x and y in [0, 1]. */
#define OPENING_FIELDS(F) \
    F(vec3,  corner) \
    F(vec3,  a) \
    F(vec3,  b) \
    F(vec3,  n)             /* unit normal, out of the box */ \
    F(float, inverse_area)  /* 0: no opening */
#define OPENING_MEMBER(type, name) type name;
typedef struct { OPENING_FIELDS(OPENING_MEMBER) } guide_opening;

/* Vertices of each survey path that the guide is learnt from. */
#define SURVEY_VERTICES 4

/* The path guide: from which directions light reaches each place, after any number of bounces, learned before a render. Space is cut by a
   tree for each of the GUIDE_FACES: for surfaces whose normal is nearest to +x, -x, +y, -y, +z, -z, and for those lit from both sides. A
   leaf has a map: a probability for each of PATH_GUIDE_SIDE^2 equal parts of the sphere of directions, as the alias tables of a square.
   Map 0 is that of places where nothing was learned; no direction is sampled by it.
   After Mueller, Gross and Novak 2017 ("Practical path guiding"); here all is learned before the first sample of the image. */
#define PATH_GUIDE_SIDE 16
#define PATH_GUIDE_ENTRIES (PATH_GUIDE_SIDE + PATH_GUIDE_SIDE * PATH_GUIDE_SIDE)
/* Node f < GUIDE_FACES is the root of face f. */
typedef struct {
    float at;     /* points below it go to node `next`, others to the one behind that */
    uint axis;    /* 0, 1 or 2; PATH_GUIDE_LEAF: a leaf */
    uint next;    /* of a leaf: its map */
} path_guide_node;
#define PATH_GUIDE_LEAF 3u
/* No leaf is deeper. */
#define PATH_GUIDE_DEPTH 24

/* A node of the light tree: what bounds the lights under each of its eight children, as in a `bvh_node` side by side.
   Conty Estevez and Kulla 2018, "Importance sampling of many lights with adaptive tree splitting". */
#define LIGHT_TREE_WIDTH 8
typedef struct {
    float x[LIGHT_TREE_WIDTH], y[LIGHT_TREE_WIDTH], z[LIGHT_TREE_WIDTH], radius[LIGHT_TREE_WIDTH];  /* a sphere around them */
    float axis_x[LIGHT_TREE_WIDTH], axis_y[LIGHT_TREE_WIDTH], axis_z[LIGHT_TREE_WIDTH];             /* a cone of their normals ... */
    float cos_normals[LIGHT_TREE_WIDTH];     /* ... and cosine of its angle */
    float cos_emission[LIGHT_TREE_WIDTH];    /* in [0, 1): how far from its normal any of them emits */
    float intensity[LIGHT_TREE_WIDTH];       /* sum of luminous intensities along the normals; 0: no child */
    uint two_sided[LIGHT_TREE_WIDTH];        /* ~0: some emit on both sides; else 0 */
    uint child[LIGHT_TREE_WIDTH];            /* a node, or with LIGHT_BIT a light */
    uint parent;                             /* node * LIGHT_TREE_WIDTH + child; NONE: this is the root, node 0 */
} light_node;
#define LIGHT_BIT 0x80000000u

CONTRACT_END
#endif
