/* Counts the steps of rays through the BVH: nodes visited and primitives tested, eight triangles at a time. Runs before a render whose
   parts are divided by cost, so it is not among the stages of a wave (host/render/traversal_steps.cpp). Moving shapes are where they are
   in the middle of the exposure. */
#define COUNTS_STEPS 1
#include "trace/bvh.clh"
#include "stages/stage.clh"

#define COUNT_TRAVERSAL_STEPS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) \
    ARGUMENT(__global const vec3 *, ray_origins) ARGUMENT(__global const vec3 *, ray_directions) \
    ARGUMENT(__global const float *, ray_ends) ARGUMENT(uint, are_shadow_rays) \
    ARGUMENT(__global uint *, steps)
TRACING_STAGE(count_traversal_steps, COUNT_TRAVERSAL_STEPS) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    int looks_for = are_shadow_rays ? traversal_blocker : traversal_nearest;
    for (size_t i = first_slot; i < SLOTS_END; ++i) {
        nearest_hit best;
        best.t_max = ray_ends[i];
        traverse_bvh(g, tables, ray_origins[i], ray_directions[i], 0.5f, looks_for, no_aim(), &best);
        steps[i] = best.steps;
    }
}
