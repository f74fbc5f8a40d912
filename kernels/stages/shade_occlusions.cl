/* hit -> next_ray, shadow, slot i to slot i; path.  Ambient occlusion (Zhukov et al. 1998; pbrt-v4's "ambientocclusion"): for every
   surface, one shadow ray of limited length towards constant ambient light; no scattered ray. Straight-line. */
#include "shade/shade_occlusion.clh"
#include "stages/stage.clh"

#define SHADE_OCCLUSIONS(TABLE, ARGUMENT) \
    COLOR_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, hit) ARGUMENT(__global uint *, next_ray) \
    ARGUMENT(__global uint *, shadow) ARGUMENT(__global uint *, path) ARGUMENT(uint, first)
STAGE(shade_occlusions, SHADE_OCCLUSIONS) {
    color_tables color_set = BIND_COLORS;
    FOR_EACH_SLOT_OF_GROUP(at, count) {
        size_t i = first + at;
        int alive = at < count;
        hit_item h = load_hit(hit, capacity, i);
        store_shadow(shadow, capacity, i, shade_occlusion(color_set, frame, h, alive));
        STORE_FIELD(ray, float, t_max, next_ray, capacity, i, -1.0f);
        if (HAS_AOVS && alive) store_albedo(path, path_capacity, h, uniform_spectrum(1.0f));
    }
}
