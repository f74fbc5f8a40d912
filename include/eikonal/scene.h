/* The scene as the device sees it: every table with its element type, and one struct for everything that is not a table.
   T(type, name).  A stage takes groups of tables as arguments (kernels/stages/stage.clh). */
#ifndef EIKONAL_SCENE_H
#define EIKONAL_SCENE_H
#include "eikonal/bvh.h"
#include "eikonal/camera.h"
#include "eikonal/light.h"
#include "eikonal/measured.h"
#include "eikonal/medium.h"
#include "eikonal/microfacet_energy.h"
#include "eikonal/motion.h"
#include "eikonal/portable.h"
#include "eikonal/shape.h"
#include "eikonal/texture.h"
CONTRACT_BEGIN

/* A material: a BSDF and the sources of its parameters. */
typedef struct {
    uint next_queue;            /* enum next_queue (stages.h): its BSDF's queue, next_crossing for a null interface, or next_mix */
    uint first_input;    /* in `material_inputs`: one for each parameter of its BSDF */
    uint input_count;
    uint displacement;   /* in `programs`: bump map; NONE: none */
    uint normal_map;     /* in `images`; NONE: none */
    uint mix_a, mix_b;   /* next_mix: in `materials` */
    uint mix_amount;     /* next_mix: in `programs`: the probability of b */
    /* with REGULARIZE: in `materials`: the same with rougher lobes, for paths that anything but a delta
       distribution has scattered; itself: nothing to roughen */
    uint regular;
    uint interior;       /* with SUBSURFACE: in `media`: the medium inside; NONE: no medium of its own */
    uint profile;        /* with DIFFUSION: in `profiles`: diffusion profile of the light that enters; NONE: it continues as a ray */
    uint transmits;      /* 1: light passes through the surface, so both sides are lit */
    uint is_clear;       /* 1: light passes nearly straight through: a null interface or a dielectric; survey paths do */
    uint disperses;      /* 1: it has an input_hero; paths that hit it terminate their secondary wavelengths */
    uint is_delta;       /* 1: its BSDF is a delta distribution */
} material;

/* A body with a diffusion profile (kernels/shade/diffusion.clh). */
typedef struct {
    color albedo;        /* fraction of the entering light that leaves again, in [0, 1] */
    color length;        /* d of the profile, scene units, > 0; with a texture: the mean free path, or the factor of path_texture */
    uint albedo_texture; /* with BODY_TEXTURES: in `programs`: the albedo where light enters; NONE: `albedo` */
    uint path_texture;   /* with BODY_TEXTURES: in `programs`: the mean free path where light enters; NONE: `length` everywhere */
    float stretch;       /* at most how much the boundary widens a profile: eta^2 - 1, at least 0 */
    uint subsurface_exit;      /* in `materials`: the material of exit points, whose BSDF is subsurface_exit */
} diffusion_profile;

enum input_kind { input_number, input_integer, input_spectrum, input_hero /* a number: its value at the path's first wavelength */,
                  input_vertex_key /* an integer: no value of the material, but a hash of the path and of its vertex */ };

/* One parameter of a material: a texture or a constant. */
typedef struct {
    uint texture;        /* in `programs`; NONE: use value */
    uint slot;           /* first word that it fills among its BSDF's parameters */
    uint kind;           /* enum input_kind */
    uint count;          /* the value of an input_integer */
    color value;         /* the value of other kinds; a number is its scale */
} material_input;

/* Read by BVH traversal. */
#define GEOMETRY_TABLES(T) \
    T(bvh_node,       nodes) \
    T(triangle_line,  triangle_lines)        /* of the leaves */ \
    T(uint,           leaf_elements)         /* element numbers of non-triangle leaves */ \
    T(uint,           element_shapes)        /* element -> shape */ \
    T(shape,          shapes) \
    T(object_space,   object_spaces) \
    T(curve,          curve_segments) \
    T(implicit,       implicits) \
    T(implicit_instruction, implicit_instructions) \
    T(uint,           implicit_doubts)       /* one counter for each enum implicit_doubt */ \
    T(instance,       instances) \
    T(motion,         motions)               /* of moving instances */ \
    T(uint,           indices)               /* vertices of each element of a mesh */ \
    T(vec3,           positions)

/* The attributes of the vertices of meshes. */
#define VERTEX_TABLES(T) \
    T(vec3,           normals) \
    T(vec2,           uvs) \
    T(vec3,           tangents)

/* Textures and images. */
#define PROGRAM_TABLES(T) \
    T(texture_program,     programs) \
    T(texture_instruction, instructions) \
    T(image,               images) \
    T(uint,                byte_texels)      /* texels of 8-bit images, four per word */ \
    T(float,               float_texels)     /* texels of floating-point images */ \
    T(float,               srgb_levels)      /* linear value of each of the 256 levels of an 8-bit sRGB channel, if any image needs it */

/* Read by texture evaluation. */
#define TEXTURE_TABLES(T) PROGRAM_TABLES(T) VERTEX_TABLES(T)

/* Read by routing, besides geometry and textures. */
#define MATERIAL_TABLES(T) \
    T(material,       materials) \
    T(material_input, material_inputs) \
    T(diffusion_profile, profiles)

/* Read by light sampling. */
#define LIGHT_TABLES(T) \
    T(light,          lights) \
    T(alias_entry,    light_aliases)         /* the light sampler: one entry per light */ \
    T(uint,           environments)          /* indices in `lights` of the infinite lights */ \
    T(float,          environment_texels)    /* TEXEL_WORDS per texel */ \
    T(alias_entry,    environment_aliases) \
    T(uint,           portal_sums)           /* summed-area table: weights of the texels above and left of each corner; below 2^31 */ \
    T(light_node,     light_nodes)           /* the light tree, root first */ \
    /* ENVIRONMENT_GUIDE: upper cell bounds along x, then y, then z: GUIDE_INTERVALS each, ascending; the last is FAR_AWAY */ \
    T(float,          guide_edges) \
    T(uint,           guide_maps)            /* map index of each cell and face: x fastest, then y, z, face */ \
    T(uint,           guide_sums)            /* GUIDE_MAP_WORDS per map */ \
    T(vec3,           guide_box)             /* its low corner, and its size */ \
    T(guide_opening,  guide_openings)        /* GUIDE_OPENINGS */ \
    T(uint,           guide_texels)          /* GUIDE_BOX_TEXELS: the opening of each texel, or NONE */ \
    /* PATH_GUIDE: the trees that cut space, the roots of all faces first; and PATH_GUIDE_ENTRIES for each map */ \
    T(path_guide_node, path_guide_nodes) \
    T(alias_entry,    path_guide_aliases)

/* Read where light paths begin. */
#define EMISSION_TABLES(T) \
    T(alias_entry,    emission_aliases)      /* LIGHT_PATHS: one entry per light */

/* Read by shading: tables of BSDFs, besides their parameters. */
#define BSDF_TABLES(T) \
    T(measured,       measured_files) \
    T(float,          measured_values) \
    T(energy_table,   energy_tables) \
    T(float,          energy_values)

#define MEDIUM_TABLES(T) \
    T(medium,         media) \
    T(motion,         medium_motions)        /* from the space of a medium to that of the scene */ \
    T(grid,           grids) \
    T(uint,           bricks)                /* of grids: index in brick_values, in units of BRICK_VALUES */ \
    T(float,          brick_values) \
    T(color,          medium_colors)         /* of rgbgrid media */ \
    T(float,          majorants) \
    T(point_light_position, point_lights)    /* MOST_EQUIANGULAR_LIGHTS at most */ \
    T(blackbody_color, blackbodies)          /* BLACKBODY_STEPS + 1, or none */ \
    INTERRUPT_TABLES(T)

/* Read by loops that may take long, medium tracking among them. Not part of a scene: host/render/stop_flag.h */
#define INTERRUPT_TABLES(T) \
    T(uint,           stop)                  /* one element; not 0: the render is interrupted, and results no longer matter */

/* The spectral range of a film that stores spectra, and how wavelengths are sampled: a fraction `share` of the samples is uniform in the
   range, the rest is uniform in the visible part outside it. In nm. */
typedef struct {
    float first, extent;          /* within [360, 830] */
    float share;                  /* in (0, 1]; 1 if the range covers everything visible */
    float inverse_pdf;            /* 1 / density of a sampled wavelength: inside the range */
    float inverse_pdf_beside;     /* and outside it */
    /* MERGING, CONNECTIONS: paths of a pass have the same wavelengths, which follow from these bits of their sample index, and this seed */
    uint pass_mask, pass_seed;
} wavelength_range;

/* Read by colour evaluation (kernels/shade/color.clh). */
#define COLOR_TABLES(T) \
    T(float,          curves)                /* CURVE_WORDS values each, at 360, 361 ... 830 nm; the first curve is 1 everywhere */ \
    T(float,          uplift)                /* coefficients of smooth spectra by colour: UPLIFT_CELLS */ \
    T(wavelength_range, wavelengths)         /* SPECTRAL_FILM, MERGING or CONNECTIONS: one element */

/* The tables of colours are empty without SPECTRAL. */
#define SHORTEST_WAVELENGTH 360
#define CURVE_WORDS 471

/* A texel of an environment: linear sRGB; with SPECTRAL, three coefficients and a scale. */
#define TEXEL_WORDS_RGB 3
#define TEXEL_WORDS_SPECTRAL 4

/* The layout of `uplift`: for each channel that may be the largest, UPLIFT_CELLS values of that channel (z) and as many ratios of the next
   two channels to it (x fastest, then y); three coefficients each. */
#define UPLIFT_CELLS 32

/* Read by ray generation. */
#define CAMERA_TABLES(T) \
    T(alias_entry,    filter_aliases) \
    T(float,          filter_values)         /* filter value over density, for each cell of filter_aliases */ \
    T(lens_element,   lens_elements)         /* from film to scene */ \
    T(pupil_bounds,   pupils)                /* PUPIL_INTERVALS elements */ \
    T(float,          aperture_texels)       /* transmission of the aperture stop, row by row, y up; its mean is pi / 4 */

/* Read by resolve_film: the Cryptomatte ID of each object and material id, whose first is that of no surface. */
#define MATTE_TABLES(T) \
    T(uint,           object_matte_ids)      /* with CRYPTO_OBJECT */ \
    T(uint,           material_matte_ids)    /* with CRYPTO_MATERIAL */

#define SCENE_TABLES(T) \
    GEOMETRY_TABLES(T) TEXTURE_TABLES(T) MATERIAL_TABLES(T) LIGHT_TABLES(T) EMISSION_TABLES(T) BSDF_TABLES(T) MEDIUM_TABLES(T) \
        COLOR_TABLES(T) CAMERA_TABLES(T) MATTE_TABLES(T) \
    T(settings,       frame)

/* The most rays that one camera ray may split into (kernels/shade/ray_splitting.clh). */
#define MOST_SPLIT_RAYS 64
/* With ray splitting, up to this many lights are all sampled at each surface; with more, one is chosen. */
#define MOST_TREE_LIGHTS 16

/* Settings of the whole render; a table of one element. */
typedef struct {
    camera view;
    filter pixel_filter;
    uint width, height;    /* of the full image, pixels */
    uint seed;
    uint sequence_sample_bits; /* SOBOL: where pixels share a sequence: bits of the sample index of each pixel */
    uint sequence_tile_bits;   /* SOBOL: 2^bits x 2^bits pixels share a sequence; at most 8; 0: each has its own */
    uint max_depth;        /* most scattering events of a path */
    uint roulette_depth;   /* scattering events before Russian roulette starts */
    uint roulette_root;    /* 1: survival probability follows the square root of the throughput; 0: the throughput */
    float roulette_scale;  /* factor of the survival probability, > 0 */
    float guided_share;    /* PATH_GUIDE: the probability that a direction is sampled by the guide, where it has a map; in [0, 1) */
    color ambient;         /* AMBIENT_OCCLUSION: radiance from unoccluded directions */
    float ambient_distance; /* AMBIENT_OCCLUSION: length of shadow rays, scene units */
    uint ambient_cosine;   /* 1: cosine-weighted directions; 0: uniform */
    uint tree_splits;       /* RAY_SPLITTING: one camera ray may become 2^tree_splits rays */
    uint rough_splits;      /* RAY_SPLITTING: 2^rough_splits rays leave a rough surface; NONE: none */
    uint tree_lights;       /* RAY_SPLITTING: lights sampled per vertex, each with pmf 1; 0: one is chosen */
    float tree_threshold;   /* RAY_SPLITTING: rays of less weight end */
    uint emission_count;   /* LIGHT_PATHS: entries of `emission_aliases`: all lights */
    uint light_count;      /* entries of `light_aliases`; 0: the light tree is used, or there is nothing to sample */
    uint first_infinite, infinite_count; /* infinite lights, last in `lights`: with LIGHT_TREE each is as probable as the whole tree */
    uint lights_in_tree;     /* number of lights in the tree */
    float world_scale;     /* world units per unit of scene space */
    uint sensor_curves;    /* with SPECTRAL: first of three in `curves`: linear sRGB of the image for light of each wavelength */
    uint albedo_curves;    /* with SPECTRAL: first of three in `curves`: linear sRGB of a reflectance in daylight */
    uint bucket_count;     /* SPECTRAL_FILM: number of equal buckets that divide the range of `wavelengths`; 0 without */
    affine image_from_light; /* without SPECTRAL: a linear map from linear sRGB light to that of the image */
    float splat_scale;       /* LIGHT_PATHS: splats are stored times this, a power of two, in fixed point (film.h) */
    float merge_radius;      /* MERGING: within which vertices merge, in the first pass; scene units */
    float merge_density;     /* MERGING: area of that radius, times the light paths of a pass whose vertices are stored */
    uint stored_share;       /* MERGING: vertices of one light path in 2^stored_share are stored */
    uint cached_share;       /* CONNECTIONS: hits of one light path in 2^cached_share are cached */
    float max_component_value; /* samples of the image brighter than this are scaled down to it; 0: no limit */
} settings;

CONTRACT_END
#endif
