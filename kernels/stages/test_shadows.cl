/* shadow -> path.  Adds the light of unoccluded shadow rays, times the transmittance of media. A tracing stage. */
#include "trace/interleaved.clh"
#include "trace/test_shadow.clh"
#include "stages/stage.clh"

FN int begin_ray(traversal *w, geometry g, texture_tables tables, color_tables colors, __global const uint *shadow, uint capacity,
                 __global const uint *stop, uint i, uint *tested) {
    if (is_interrupted(stop) || LOAD_FIELD(shadow, float, t_max, shadow, capacity, i) < 0.0f) return 0;
    ++*tested;
    return begin_shadow(w, g, tables, colors, load_shadow(shadow, capacity, i));
}
FN void end_ray(const traversal *w, geometry g, texture_tables tables, medium_tables media, color_tables colors,
                __global const uint *shadow, uint capacity, __global uint *path, uint path_capacity) {
    if (w->found) return;
    shadow_item s = load_shadow(shadow, capacity, w->slot);
    spectrum L = unblocked_light(g, tables, media, colors, s);
    if (is_black(L)) return;
    add_radiance(path, path_capacity, s.path, L, s.render_pass);
    add_to_group(path, path_capacity, s.path, L, s.group);
}

#define BEGIN_RAY(w, i) begin_ray(w, g, tables, color_set, shadow, capacity, stop, i, &tested)
#define END_RAY(w) end_ray(w, g, tables, medium_set, color_set, shadow, capacity, path, path_capacity)

#define TEST_SHADOWS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) MEDIUM_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const uint *, shadow) ARGUMENT(__global uint *, path) ARGUMENT(__global uint *, shadow_count)
TRACING_STAGE(test_shadows, TEST_SHADOWS) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    medium_tables medium_set = BIND_MEDIA;
    color_tables color_set = BIND_COLORS;
    uint tested = 0;
    TRAVERSE_INTERLEAVED(g, tables, traversal_blocker, SLOTS_END, BEGIN_RAY, END_RAY);
    if (tested) atomic_add(shadow_count, tested);
}
