/* miss -> path.  Adds the radiance of the environments along rays that left the scene. Straight-line; the number of environments is a
   build-time constant. */
#include "shade/shade_miss.clh"
#include "stages/stage.clh"

#define SHADE_MISSES(TABLE, ARGUMENT) \
    LIGHT_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const uint *, miss) ARGUMENT(__global uint *, path)
STAGE(shade_misses, SHADE_MISSES) {
    light_tables light_set = BIND_LIGHTS;
    color_tables color_set = BIND_COLORS;
    FOR_EACH_SLOT_OF_GROUP(i, count) {
        miss_item m = load_miss(miss, capacity, i);
        m.guide = i < count ? m.guide : 0u;
        spectrum L = shade_miss(light_set, color_set, m);
        size_t at = i < count ? m.path : DISCARDED_PATH(i);
        add_radiance(path, path_capacity, at, L, i < count ? m.render_pass : 0u);
        add_to_groups(light_set, color_set, m, path, path_capacity, at);
    }
}
