/* Every shape. An element is what the acceleration structure holds: one triangle, one patch, one sphere, one part of a curve. Elements are
   numbered through the whole scene, shape after shape.
   S(name, FEATURE).  A shape called x is kernels/shape/x.clh, which defines intersect_x and eval_x (the point and its frame). */
#ifndef EIKONAL_SHAPES_H
#define EIKONAL_SHAPES_H
#include "eikonal/motion.h"
#include "eikonal/portable.h"
CONTRACT_BEGIN

#define SHAPES(S) \
    S(triangle, SHAPE_TRIANGLE) \
    S(bilinear, SHAPE_BILINEAR) \
    S(sphere,   SHAPE_SPHERE) \
    S(disk,     SHAPE_DISK) \
    S(cylinder, SHAPE_CYLINDER) \
    S(curve,    SHAPE_CURVE) \
    S(implicit, SHAPE_IMPLICIT)

#define SHAPE_KIND(name, FEATURE) shape_##name,
enum shape_kind { SHAPES(SHAPE_KIND) shape_kinds };

enum shape_flag {
    shape_reversed      = 1, /* the normal is flipped: ReverseOrientation, or a mirroring transform, not both */
    shape_has_interface = 2, /* inside and outside name its media; otherwise a ray keeps its medium */
    shape_is_interface  = 4, /* its material is "interface": shadow rays pass */
    shape_is_unseen     = 8  /* its alpha is 0: no ray meets it, but what it emits shines */
};

/* One shape: a mesh, a quadric, an implicit surface or a run of curves, and what it is made of. */
typedef struct {
    uint kind;           /* enum shape_kind */
    uint flags;          /* enum shape_flag */
    uint first_element;  /* number of its first element */
    uint first_index;    /* meshes: its vertex indices start here in `indices`; 3 or 4 for an element; curves: its segments in `curve_segments`; its place in `implicits` */
    uint first_vertex;   /* meshes: added to every index */
    uint first_normal;   /* meshes: its normals start here in `normals`, one a vertex; NONE: it has none */
    uint first_tangent;  /* meshes: its tangents in `tangents`, one a vertex; NONE: they follow the texture coordinates; only with TANGENTS */
    uint first_uv;       /* meshes: its texture coordinates in `uvs`, one a vertex; NONE: the element's own (u, v) */
    uint quadric;        /* in `quadrics`; NONE for meshes; implicit surfaces: only the maps count; curves: only the maps count, and NONE means that there is no need for them */
    uint splits;         /* curves: each segment is 2^splits elements, one after the other */
    uint material;       /* in `materials` */
    uint alpha;          /* in `programs`: the texture that cuts it out; NONE: solid */
    uint first_light;    /* of its first element, in `lights`; NONE: it emits nothing */
    uint emission;       /* in `programs`: its radiance relative to its lights'; NONE: even */
    uint id;             /* which object of the scene this is, for people: from 1; 0: its instance says */
    uint inside, outside; /* in `media`, NONE for vacuum: only with shape_has_interface */
} shape;

/* A sphere, disk or cylinder in a space of its own. */
typedef struct {
    affine object_from_scene;
    affine scene_from_object;
    float radius;
    float inner_radius;  /* disk */
    float z_min, z_max;  /* sphere, cylinder; disk: z_min is its height */
    float phi_max;       /* in (0, 2 pi] */
} quadric;

enum curve_type { curve_flat, curve_cylinder, curve_ribbon };

/* A cubic Bezier curve with a width, in the space of its hierarchy unless its shape names a quadric. */
typedef struct {
    vec3 p[4];           /* control points */
    float width[2];      /* at both ends, linear in between */
    uint type;           /* enum curve_type */
    float normal_angle;  /* ribbon: between its normals, in [0, pi); 0: n[0] everywhere */
    vec3 n[2];           /* ribbon: normals at both ends, of unit length */
} curve;

/* What the program of an implicit surface is made of: each instruction sets one register to a function of one or two others. */
enum implicit_operation {
    implicit_number,         /* number */
    implicit_add,            /* a + b */
    implicit_subtract,       /* a - b */
    implicit_shift,          /* a + number */
    implicit_scale,          /* a * number */
    implicit_multiply,       /* a * b */
    implicit_square,         /* a * a */
    implicit_integer_power,  /* a^b: b is an integer, 3 or more */
    implicit_power,          /* a^number, a >= 0: number > 0 */
    implicit_reciprocal,     /* 1 / a */
    implicit_sqrt, implicit_exp, implicit_log, implicit_sine, implicit_asin, implicit_atan, implicit_abs,   /* of a */
    implicit_min, implicit_max,
    implicit_atan2           /* the angle of the point (b, a) */
};

/* Registers 0, 1 and 2 hold x, y and z. */
#define IMPLICIT_REGISTERS 32

typedef struct {
    uint operation;          /* enum implicit_operation */
    uint target, a, b;       /* registers */
    float number;
    float limit;             /* powers: the largest number whose power is not too large */
} implicit_instruction;

/* The surface F(x, y, z) = 0 within a box, object space; its maps are in `quadrics`. */
typedef struct {
    vec3 low, high;
    uint first_instruction;  /* in `implicit_instructions`; the last one's target is F */
    uint instruction_count;
} implicit;

/* One placed copy of an object: a second level below the scene's hierarchy. One that moves is placed by its motions, the first of
   which is the outermost: an object that moves, in which a shape moves. */
typedef struct {
    affine object_from_scene;
    affine scene_from_object;
    uint root;           /* node of the object's own hierarchy */
    uint first_motion;   /* in `motions` */
    uint motion_count;   /* 0: it stands still */
    uint id;             /* which object of the scene this is, for people: from 1; 0: its shapes say */
} instance;

CONTRACT_END
#endif
