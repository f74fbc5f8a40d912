/* shadow -> path.  Adds the light of unoccluded shadow rays, times the transmittance of media. A tracing stage. */
#include "stages/queue.clh"
#include "trace/bvh.clh"
#include "math/dimension.clh"
#include "light/pattern.clh"
#include "medium/medium.clh"
#include "eikonal/stages.h"
#include "stages/stage.clh"

/* A shadow ray that crosses more null interfaces than this counts as blocked. */
#define MOST_INTERFACES 256

/* Multiply by the transmittance of media along an unoccluded shadow ray. Dielectric surfaces block, as in pbrt-v4. */
FN spectrum attenuate_shadow(geometry g, texture_tables tables, medium_tables media, color_tables color_set, shadow_item s) {
    tracked_path path = {hero_channel(s.seed, s.sample), s.Ld, s.r_u, s.r_l, uniform_spectrum(0.0f)};
    sampled_wavelengths colors = path_wavelengths(color_set, s.seed, s.sample);
    random_stream more = make_stream(s.seed, s.sample, bounce_dimension_of(s.depth, dimension_transmittance));
    vec3 o = s.o;
    float left = s.t_max;
    uint medium_here = s.medium;
    for (int crossed = 0; crossed < MOST_INTERFACES; ++crossed) {
        nearest_hit boundary;
        boundary.t_max = left;
        int found = HAS_INTERFACE && walk_bvh(g, tables, o, s.d, s.time, walk_interface, &boundary);
        if (medium_here != NONE) attenuate_medium(media, colors, medium_here, o, s.d, found ? boundary.t_max : left, &more, &path);
        if (is_black(path.beta)) return path.beta;
        if (!found) return mul(path.beta, 1.0f / max1(mean_component(add(path.r_u, path.r_l)), 1e-30f));

        /* Continue behind the null interface */
        shape_hit hit = {boundary.t_max, boundary.u, boundary.v};
        surface at = eval_surface(g, tables, boundary.element, boundary.instance, o, s.d, s.time, hit);
        shape between = g.shapes[g.element_shapes[boundary.element]];
        if (between.flags & shape_has_interface) medium_here = dot3(at.ng, s.d) > 0.0f ? between.outside : between.inside;
        o = offset_origin(at.p, surface_offset(at), at.ng, s.d);
        left -= boundary.t_max;
    }
    return uniform_spectrum(0.0f);
}

FN spectrum test_shadow(geometry g, texture_tables tables, medium_tables media, color_tables colors, shadow_item s) {
    nearest_hit any;
    any.t_max = s.t_max;
    if (walk_bvh(g, tables, s.o, s.d, s.time, walk_blocker, &any)) return uniform_spectrum(0.0f);
    if (HAS_LIGHT_PATTERN && s.element != NONE) s.Ld = mul(s.Ld, light_pattern(g, tables, path_wavelengths(colors, s.color_seed, s.color_sample), s));
    return HAS_MEDIA ? attenuate_shadow(g, tables, media, colors, s) : s.Ld;
}

#ifndef AS_LIBRARY
#define TEST_SHADOWS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) MEDIUM_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const uint *, shadow) ARGUMENT(__global uint *, path) ARGUMENT(__global uint *, shadow_count)
TRACING_STAGE(test_shadows, TEST_SHADOWS) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    medium_tables medium_set = BIND_MEDIA;
    color_tables color_set = BIND_COLORS;
    uint tested = 0;
    for (size_t i = first_slot; i < SLOTS_END; ++i) {
        if (LOAD_FIELD(shadow, float, t_max, shadow, capacity, i) < 0.0f) continue;
        ++tested;
        shadow_item s = load_shadow(shadow, capacity, i);
        spectrum L = test_shadow(g, tables, medium_set, color_set, s);
        if (!is_black(L)) add_radiance(path, path_capacity, s.path, L);
    }
    if (tested) atomic_add(shadow_count, tested);
}
#endif
