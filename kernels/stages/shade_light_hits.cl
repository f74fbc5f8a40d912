/* hit -> next_ray, shadow, slot i to slot i.  Takes each light path one step on where it is scattered: a ray to the camera, and one
   scattered ray (shade/shade_light_hit.clh). Built once per BSDF (the macro BSDF), over that BSDF's segment of the hit queue. */
#include "shade/shade_light_hit.clh"
#include "stages/stage.clh"

#define SHADE_LIGHT_HITS(TABLE, ARGUMENT) \
    BSDF_TABLES(TABLE) COLOR_TABLES(TABLE) CAMERA_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, hit) ARGUMENT(__global uint *, next_ray) \
    ARGUMENT(__global uint *, shadow) ARGUMENT(uint, first)
STAGE(shade_light_hits, SHADE_LIGHT_HITS) {
    bsdf_tables bsdf_set = BIND_BSDFS;
    color_tables color_set = BIND_COLORS;
    camera_tables camera_set = BIND_CAMERA;
    FOR_EACH_SLOT_OF_GROUP(at, count) {
        size_t i = first + at;
        int alive = at < count;
        if (BSDF_LOOPS && !alive) {
            STORE_FIELD(ray, float, t_max, next_ray, capacity, i, -1.0f);
            STORE_FIELD(shadow, float, t_max, shadow, capacity, i, -1.0f);
            continue;
        }
        hit_item h = load_hit(hit, capacity, i);
        BSDF_BOUND b = BIND_BSDF(h, LOAD_BSDF(hit, capacity, i), bsdf_set, color_set);
        frame3 shading = shading_frame(h);
        vec3 wo = to_local(shading, h.wo);
        if (!BSDF_IS_DELTA) store_shadow(shadow, capacity, i, CONNECT_BSDF(camera_set, frame, h, b, shading, wo, alive));
        else STORE_FIELD(shadow, float, t_max, shadow, capacity, i, -1.0f);
        store_ray(next_ray, capacity, i, SCATTER_POWER_BSDF(frame, h, b, shading, wo, alive));
    }
}
