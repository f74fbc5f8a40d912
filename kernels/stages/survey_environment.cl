/* Measures the visibility of a constant environment in each bin of each map of the environment guide: the sum of the cosines of unoccluded
   rays. Each map has `representatives` points with normals; each point casts one ray into each bin. For a normal of zero length, the cosine
   counts as 1. Runs before a render (host/render/survey.cpp). */
#include "trace/bvh.clh"
#include "light/light.clh"
#include "math/random.clh"
#include "stages/stage.clh"

#define SURVEY_ENVIRONMENT(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) \
    ARGUMENT(__global const vec3 *, survey_points) ARGUMENT(__global const vec3 *, survey_normals) \
    ARGUMENT(__global float *, survey_weights) \
    ARGUMENT(uint, representatives)
TRACING_STAGE(survey_environment, SURVEY_ENVIRONMENT) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    for (uint i = (uint)first_slot; i < SLOTS_END; ++i) {
        uint bin = i % (GUIDE_SIDE * GUIDE_SIDE), map = i / (GUIDE_SIDE * GUIDE_SIDE);
        random_stream numbers = make_stream(1u, i, 0u);
        float sum = 0.0f;
        for (uint k = map * representatives; k < (map + 1u) * representatives; ++k) {
            float x = (float)(bin % GUIDE_SIDE) + next_random(&numbers), y = (float)(bin / GUIDE_SIDE) + next_random(&numbers),
                  time = next_random(&numbers);
            vec3 d = equal_area_sphere(make_vec2(x * (1.0f / GUIDE_SIDE), y * (1.0f / GUIDE_SIDE))), n = survey_normals[k];
            float cosine = length_squared(n) > 0.0f ? dot3(n, d) : 1.0f;
            if (!(cosine > 0.0f)) continue;
            nearest_hit any;
            any.t_max = FAR_AWAY;
            sum += traverse_bvh(g, tables, survey_points[k], d, time, traversal_blocker, &any) ? 0.0f : cosine;
        }
        survey_weights[i] = sum;
    }
}
