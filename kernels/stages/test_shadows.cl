/* shadow -> path.  Adds the light of unoccluded shadow rays, times the transmittance of media. A tracing stage. */
#include "trace/test_shadow.clh"
#include "stages/stage.clh"

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
        if (is_interrupted(stop)) return;
        if (LOAD_FIELD(shadow, float, t_max, shadow, capacity, i) < 0.0f) continue;
        ++tested;
        shadow_item s = load_shadow(shadow, capacity, i);
        spectrum L = test_shadow(g, tables, medium_set, color_set, s);
        if (is_black(L)) continue;
        add_radiance(path, path_capacity, s.path, L, s.render_pass);
        add_to_group(path, path_capacity, s.path, L, s.group);
    }
    if (tested) atomic_add(shadow_count, tested);
}
