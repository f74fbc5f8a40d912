/* The scene as the device sees it: every table, its element type, and the struct of all that is not a table.
   T(type, name).  A stage has a group of tables among its arguments (kernels/stages/stage.clh). */
#ifndef EIKONAL_SCENE_H
#define EIKONAL_SCENE_H
#include "eikonal/bvh.h"
#include "eikonal/cameras.h"
#include "eikonal/lights.h"
#include "eikonal/measured.h"
#include "eikonal/media.h"
#include "eikonal/motion.h"
#include "eikonal/portable.h"
#include "eikonal/shapes.h"
#include "eikonal/textures.h"
CONTRACT_BEGIN

/* A material: which BSDF, and where its parameters come from. */
typedef struct {
    uint next_queue;            /* enum next_queue (stages.h): its BSDF's queue, or next_crossing for an interface, or next_mix */
    uint first_input;    /* in `material_inputs`: one for each parameter of its BSDF */
    uint input_count;
    uint displacement;   /* in `programs`: bump map; NONE: none */
    uint normal_map;     /* in `images`; NONE: none */
    uint mix_a, mix_b;   /* next_mix: in `materials` */
    uint mix_amount;     /* next_mix: in `programs`: the probability of b */
    uint regular;        /* with REGULARIZE: in `materials`: the same, rougher, for paths that are blurred already; itself: nothing is to be roughened */
    uint interior;       /* with SUBSURFACE: in `media`: what is inside of it; NONE: nothing of its own */
    uint profile;        /* with DIFFUSION: in `profiles`: how light that has entered spreads; NONE: it goes on as a ray */
    uint transmits;      /* 1: light goes through its surface, so that surfaces are lit from both sides */
    uint disperses;      /* 1: it has an input_hero, and paths that meet it go on with their first wavelength */
} material;

/* A body that light is diffused in: how much comes out where (kernels/shade/diffusion.clh). */
typedef struct {
    color albedo;        /* share of the light that has entered that leaves again, in [0, 1] */
    color length;        /* d of the profile, scene units, > 0; with a texture: the mean free path, or what path_texture is multiplied by */
    uint albedo_texture; /* with BODY_TEXTURES: in `programs`: the albedo where light enters; NONE: `albedo` everywhere */
    uint path_texture;   /* the same of the mean free path */
    float stretch;       /* how much wider the boundary makes a profile, at most: eta^2 - 1, at least 0 */
    uint subsurface_exit;      /* in `materials`: how its surface lets light out */
} diffusion_profile;

enum input_kind { input_number, input_count, input_spectrum, input_hero /* a number: the value at the path's first wavelength */ };

/* One parameter of a material: a texture, or else a value. */
typedef struct {
    uint texture;        /* in `programs`; NONE: use value */
    uint slot;           /* which word of its BSDF's parameters it fills first */
    uint kind;           /* enum input_kind */
    uint count;          /* input_count: the value */
    color value;         /* otherwise; a number is its scale */
} material_input;

/* What traversal reads. */
#define GEOMETRY_TABLES(T) \
    T(bvh_node,       nodes) \
    T(triangle_line,  triangle_lines)        /* of the leaves */ \
    T(uint,           leaf_elements)         /* elements, or instances, by leaf kind */ \
    T(uint,           element_shapes)        /* element -> shape */ \
    T(shape,          shapes) \
    T(quadric,        quadrics) \
    T(curve,          curve_segments) \
    T(implicit,       implicits) \
    T(implicit_instruction, implicit_instructions) \
    T(instance,       instances) \
    T(motion,         motions)               /* of instances that move */ \
    T(uint,           indices)               /* vertices of each element of a mesh */ \
    T(vec3,           positions)

/* What evaluating textures reads. */
#define TEXTURE_TABLES(T) \
    T(texture_program,     programs) \
    T(texture_instruction, instructions) \
    T(image,               images) \
    T(uint,                byte_texels)      /* texels of 8-bit images, four in a word */ \
    T(float,               float_texels)     /* texels of floating-point images */ \
    T(float,               srgb_levels)      /* linear light of each of the 256 values of an 8-bit sRGB channel, if an image has them */ \
    T(vec3,                normals) \
    T(vec2,                uvs) \
    T(vec3,                tangents)

/* What routing reads besides geometry and textures. */
#define MATERIAL_TABLES(T) \
    T(material,       materials) \
    T(material_input, material_inputs) \
    T(diffusion_profile, profiles)

/* What light sampling reads. */
#define LIGHT_TABLES(T) \
    T(light,          lights) \
    T(alias_entry,    light_aliases)         /* the light sampler: one entry a light */ \
    T(uint,           environments)          /* those of `lights` that surround the scene */ \
    T(float,          environment_texels)    /* TEXEL_WORDS for each texel */ \
    T(alias_entry,    environment_aliases) \
    T(uint,           portal_sums)           /* of the weights of texels above and left of each texel's corner; below 2^31 */ \
    T(light_node,     light_nodes)           /* the light tree; its root comes first */ \
    T(float,          guide_edges)           /* ENVIRONMENT_GUIDE: where its cells end along x, then y, then z: GUIDE_INTERVALS each, ascending; the last: FAR_AWAY */ \
    T(uint,           guide_maps)            /* which map each face of each cell has: x fastest, then y, z, and the face before them */ \
    T(alias_entry,    guide_aliases)         /* GUIDE_MAP_ENTRIES for each map */

/* What shading reads of surfaces besides their parameters. */
#define BSDF_TABLES(T) \
    T(measured,       measured_files) \
    T(float,          measured_values)

#define MEDIUM_TABLES(T) \
    T(medium,         media) \
    T(grid,           grids) \
    T(uint,           bricks)                /* of grids: which of brick_values, BRICK_VALUES each */ \
    T(float,          brick_values) \
    T(color,          medium_colors)         /* of rgbgrid media */ \
    T(float,          majorants) \
    T(point_light_position, point_lights)    /* MOST_EQUIANGULAR_LIGHTS at most */ \
    T(blackbody_color, blackbodies)          /* BLACKBODY_STEPS + 1, or none */

/* The wavelengths that a film keeps a spectrum of, and how they are sampled: `share` of the samples evenly within the range, the others evenly in
   what the eye sees beside it. nm. */
typedef struct {
    float first, extent;          /* from 360 on, and not beyond 830 */
    float share;                  /* in (0, 1]; 1 if there is nothing beside the range */
    float inverse_pdf;            /* one over the density of a sample's wavelength: within the range ... */
    float inverse_pdf_beside;     /* ... and beside it */
} wavelength_range;

/* What reading colours takes (kernels/shade/color.clh). */
#define COLOR_TABLES(T) \
    T(float,          curves)                /* CURVE_WORDS values each, at 360, 361 ... 830 nm; the first is 1 everywhere */ \
    T(float,          uplift)                /* coefficients of smooth spectra by colour: UPLIFT_CELLS (kernels/shade/color.clh) */ \
    T(wavelength_range, wavelengths)         /* SPECTRAL_FILM: one */

/* Only with SPECTRAL is there anything in these tables. */
#define SHORTEST_WAVELENGTH 360
#define CURVE_WORDS 471

/* A texel of an environment: linear sRGB; with SPECTRAL, three coefficients and a scale. */
#define TEXEL_WORDS_RGB 3
#define TEXEL_WORDS_SPECTRAL 4

/* The colours of `uplift`: for each channel that may be the largest, UPLIFT_CELLS values of it (z), and as many ratios of the next two to it
   (x fastest, then y); three coefficients each. */
#define UPLIFT_CELLS 32

/* What ray generation reads. */
#define CAMERA_TABLES(T) \
    T(alias_entry,    filter_aliases) \
    T(float,          filter_values)         /* value over density, for each cell of filter_aliases */ \
    T(lens_element,   lens_elements)         /* from the film to the scene */ \
    T(pupil_bounds,   pupils)                /* PUPIL_INTERVALS of them */ \
    T(float,          aperture_texels)       /* what the stop lets pass, row by row, y up; of mean pi / 4 */

#define SCENE_TABLES(T) \
    GEOMETRY_TABLES(T) TEXTURE_TABLES(T) MATERIAL_TABLES(T) LIGHT_TABLES(T) BSDF_TABLES(T) MEDIUM_TABLES(T) COLOR_TABLES(T) CAMERA_TABLES(T) \
    T(settings,       frame)

/* The most rays that a camera ray may become (kernels/shade/ray_splitting.clh). */
#define MOST_TREE_RAYS 64
/* With so many lights it looks at all of them at each surface, otherwise at one that it chooses. */
#define MOST_TREE_LIGHTS 16

/* What holds for a whole render; a table of one element. */
typedef struct {
    camera view;
    filter pixel_filter;
    uint width, height;    /* of the whole image, pixels */
    uint seed;
    uint sequence_sample_bits; /* SOBOL: where pixels share a sequence, the samples of each are numbered with so many bits */
    uint sequence_tile_bits;   /* and 2^bits x 2^bits pixels share it; at most 8; 0: each pixel has its own */
    uint max_depth;        /* most scattering events on a path */
    uint roulette_depth;   /* scattering events before Russian roulette */
    uint roulette_root;    /* 1: a path goes on with the square root of its throughput; 0: with its throughput; */
    float roulette_scale;  /*   times this, > 0 */
    color ambient;         /* AMBIENT_OCCLUSION: what arrives from where nothing is near */
    float ambient_distance; /* how near that is, scene units */
    uint ambient_cosine;   /* 1: directions follow the cosine; 0: they are uniform */
    uint tree_splits;       /* TREE: a camera ray may become 2^tree_splits rays */
    uint rough_splits;      /* 2^rough_splits rays leave a rough surface; NONE: none */
    uint tree_lights;      /* so many lights are looked at, each of pmf 1; 0: one is chosen */
    float tree_threshold;  /* rays of less weight are not followed */
    uint light_count;      /* entries of `light_aliases`; 0: there is a light tree instead, or nothing to sample */
    uint first_infinite, infinite_count; /* lights infinitely far away, last in `lights`: with LIGHT_TREE each is as likely as the tree */
    uint lights_in_tree;     /* how many lights the tree holds */
    float world_scale;     /* world units in one unit of scene space */
    uint sensor_curves;    /* with SPECTRAL, in `curves`: three, linear sRGB of the image for light of each wavelength */
    uint albedo_curves;    /* with SPECTRAL, in `curves`: three, linear sRGB of a reflectance in daylight */
    uint bucket_count;     /* SPECTRAL_FILM: buckets of equal width that the range of `wavelengths` is cut into; 0 without */
    float max_component_value; /* brighter samples are scaled down to it; 0: none are */
} settings;

CONTRACT_END
#endif
