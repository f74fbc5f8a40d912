/* pixels -> ray.  Generates the first ray of a light path for each sample of some blocks of the whole image, in the slots from 0 on. The
   batch's arguments are those of generate_rays. A tracing stage. */
#include "camera/camera.clh"
#include "film/pixel.clh"
#include "light/emission.clh"
#include "shape/surface.clh"
#include "stages/stage.clh"

/* The ray of an emission, offset from its light and dimmed by the light's pattern there. */
FN ray_item leave_light(geometry g, texture_tables tables, sampled_wavelengths colors, ray_item r, emission e) {
    r.beta = e.beta;
    r.o = e.from.p;
    r.d = e.d;
    r.medium = e.l.medium;
    if (e.place != place_AREA || e.l.element == NONE) return r;
    /* Look at the point from above, as a shadow ray would */
    vec3 n = face_forward(e.from.n, e.d);
    float height = max1(0.5f / sqrt(max1(e.from.density, 1e-20f)), 1e-6f);
    surface at = aimed_surface(g, tables, e.l.element, mul_add(n, height, e.from.p), negate(n), height);
    r.o = offset_origin(e.from.p, surface_offset(at), at.ng, e.d);
    shape lamp = g.shapes[g.element_shapes[e.l.element]];
    if (lamp.flags & shape_has_interface) r.medium = dot3(at.ng, e.d) > 0.0f ? lamp.outside : lamp.inside;
    if (HAS_LIGHT_PATTERN && e.l.has_pattern) r.beta = mul(r.beta, pattern_at(g, tables, colors, e.l.element, at, negate(e.d)));
    return r;
}

#define GENERATE_LIGHT_RAYS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) LIGHT_TABLES(TABLE) EMISSION_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global uint *, ray) BATCH_ARGUMENTS(ARGUMENT) \
    ARGUMENT(uint, begun) ARGUMENT(uint, first_path) ARGUMENT(uint, first)
TRACING_STAGE(generate_light_rays, GENERATE_LIGHT_RAYS) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    light_tables light_set = BIND_LIGHTS;
    color_tables color_set = BIND_COLORS;
    for (size_t i = first_slot; i < SLOTS_END; ++i) {
        uint of_batch = begun + (uint)i;
        pixel_sample at = LOCATE_PATH(of_batch);
        ray_item r = begin_path(frame, at.x, at.y, at.sample, first_path + of_batch);
        r.seed = hash_uint(r.seed, LIGHT_PATH_SEED);
        r.has_nonspecular_vertex = 1u;  /* the auxiliary channels show nothing of it */
        r.wavelength = wavelength_number(color_set.wavelengths, r.seed, r.sample);
        sampled_wavelengths colors = path_wavelengths(color_set, r.wavelength);
        emission e = sample_emission(light_set, emission_aliases, colors, frame->emission_count, r.seed, r.sample);
        r = leave_light(g, tables, colors, r, e);
        r.vertex = r.o;
        r.t_max = at.in_image && max_component(r.beta) > 0.0f ? FAR_AWAY : -1.0f;
        store_ray(ray, capacity, first + i, r);
    }
    /* The slots behind the last path of the group are dead */
    for (size_t i = max(first_slot, (size_t)count); i < first_slot + ITEMS_PER_WORK_ITEM; ++i)
        STORE_FIELD(ray, float, t_max, ray, capacity, first + i, -1.0f);
}
