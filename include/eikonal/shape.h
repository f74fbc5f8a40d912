/* A shape as kernels see it, and what each kind keeps in tables of its own. Its kinds: shapes.h. */
#ifndef EIKONAL_SHAPE_H
#define EIKONAL_SHAPE_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

enum shape_flag {
    shape_reversed      = 1, /* the normal is flipped: either ReverseOrientation or a mirroring transform, not both */
    shape_has_interface = 2, /* inside and outside name its media; otherwise a ray keeps its medium */
    shape_is_interface  = 4, /* its material is "interface", so shadow rays pass */
    shape_is_unseen     = 8, /* its alpha is 0: rays pass through it, but it emits */
    shape_is_two_sided  = 16, /* it emits on both sides */
    shape_is_aimed_by_direction = 32, /* it emits, and light samples are directions; rays find its points (kernels/trace/meet_light.clh) */
    shape_faces_rays    = 64, /* its normal depends on the ray that hits it (curves) */
    shape_is_entered    = 128 /* rays may go on inside of it: its material transmits, bounds a body in which paths walk, or is none */
};

/* One shape: a mesh, a quadric, an implicit surface or a list of curves, with its material. */
typedef struct {
    uint kind;           /* enum shape_kind */
    uint flags;          /* enum shape_flag bits */
    uint first_element;  /* number of its first element */
    /* meshes: first of its vertex indices in `indices`, 3 or 4 per element; curves: first of its segments in `curve_segments`; implicit
       surfaces: index in `implicits` */
    uint first_index;
    uint first_vertex;   /* meshes: added to every index */
    uint first_normal;   /* meshes: first of its normals in `normals`, one per vertex; NONE: it has none */
    uint first_tangent;  /* meshes: first of its tangents in `tangents`, one per vertex; NONE: from (u, v); only with TANGENTS */
    uint first_uv;       /* meshes: first of its texture coordinates in `uvs`, one per vertex; NONE: the element's own (u, v) */
    /* in `object_spaces`; NONE for meshes. Implicit surfaces and curves use its maps only; for curves NONE means no map is needed */
    uint object_space;
    uint splits;         /* curves: each segment is split into 2^splits elements, in order */
    uint material;       /* in `materials` */
    uint alpha;          /* in `programs`: alpha texture; NONE: opaque */
    uint first_light;    /* in `lights`: light of its first element; NONE: no emission */
    uint emission;       /* in `programs`: radiance relative to its lights; NONE: constant */
    uint id;             /* object id for the AOV, from 1; 0: the instance has the id */
    uint inside, outside; /* in `media`, NONE for vacuum; only with shape_has_interface */
} shape;

/* The maps of a shape's object space, and the numbers of a sphere, disk or cylinder in it. These three have the origin of the space
   around them: near that origin, floats are precise also on a surface that is much larger than its distance from it. */
typedef struct {
    affine object_from_scene;
    affine scene_from_object;
    float radius;
    float inner_radius;  /* disk */
    float z_min, z_max;  /* sphere, cylinder: relative to the centre; disk: z_min is its height */
    float phi_max;       /* in (0, 2 pi] */
    vec3 center;         /* of a sphere or disk; of a cylinder: x and y are its axis, z is where its z_min and z_max count from */
    float power;         /* of the origin: its squared distance from a sphere's centre or a cylinder's axis, minus radius^2 */
} object_space;

enum curve_type { curve_flat, curve_cylinder, curve_ribbon };

/* A cubic Bezier curve with a width, in the space of its BVH unless its shape has an object space. */
typedef struct {
    vec3 p[4];           /* control points */
    float width[2];      /* at both ends, interpolated linearly */
    uint type;           /* enum curve_type */
    float normal_angle;  /* ribbon: angle between the two normals, in [0, pi); 0: n[0] everywhere */
    vec3 n[2];           /* ribbon: unit normals at both ends */
} curve;

/* Instructions of an implicit surface's program: each sets one register to a function of one or two others. */
enum implicit_operation {
    implicit_number,         /* number */
    implicit_add,            /* a + b */
    implicit_subtract,       /* a - b */
    implicit_shift,          /* a + number */
    implicit_scale,          /* a * number */
    implicit_multiply,       /* a * b */
    implicit_square,         /* a * a */
    implicit_integer_power,  /* a^b for an integer b >= 3 */
    implicit_power,          /* a^number for a >= 0 and number > 0 */
    implicit_reciprocal,     /* 1 / a */
    implicit_sqrt, implicit_exp, implicit_log, implicit_sine, implicit_asin, implicit_atan, implicit_abs,   /* of a */
    implicit_min, implicit_max,
    implicit_atan2           /* angle of the point (b, a) */
};

/* Registers 0, 1 and 2 hold x, y and z at the start. */
#define IMPLICIT_REGISTERS 32

typedef struct {
    uint operation;          /* enum implicit_operation */
    uint target, a, b;       /* registers */
    float number;
    float limit;             /* powers: largest |a| whose power does not overflow */
} implicit_instruction;

/* What single precision could not decide at implicit surfaces: counters in `implicit_doubts`, which kernels increment. */
enum implicit_doubt {
    doubt_splits,            /* rays that ran out of splits: the nearest root may be missed */
    doubt_sides,             /* hits of shapes that rays enter, so near to another side of the surface that a ray may miss it */
    implicit_doubt_count
};

/* The surface F(x, y, z) = 0 within a box in object space; its maps are in `object_spaces`. */
typedef struct {
    vec3 low, high;
    uint first_instruction;  /* in `implicit_instructions`; the last instruction computes F */
    uint instruction_count;
} implicit;

/* An instance of an object: its BVH is the second level below the scene's BVH. The motions of a moving instance apply from the outermost
   inwards, such as a moving object that contains a moving shape. */
typedef struct {
    affine object_from_scene;
    affine scene_from_object;
    uint root;           /* root node of the object's BVH */
    uint first_motion;   /* in `motions` */
    uint motion_count;   /* 0: static */
    uint id;             /* object id for the AOV, from 1; 0: the shapes have the ids */
} instance;

CONTRACT_END
#endif
