/* Finds where light enters a scene: rays leave the survey's points in cosine-distributed directions; those that no surface stops leave the
   guide's box through a texel of it. survey_texels: that texel; GUIDE_BOX_TEXELS for those that miss the box, NONE for all others. Runs
   before a render (host/render/survey.cpp). */
#include "trace/bvh.clh"
#include "light/light.clh"
#include "math/random.clh"
#include "math/warp.clh"
#include "stages/stage.clh"

#define SURVEY_EXITS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) LIGHT_TABLES(TABLE) \
    ARGUMENT(__global const vec3 *, survey_points) ARGUMENT(__global const vec3 *, survey_normals) ARGUMENT(uint, point_count) \
    ARGUMENT(__global uint *, survey_texels)
TRACING_STAGE(survey_exits, SURVEY_EXITS) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    light_tables light_set = BIND_LIGHTS;
    for (uint i = (uint)first_slot; i < SLOTS_END; ++i) {
        random_stream numbers = make_stream(2u, i, 0u);
        float x = next_random(&numbers), y = next_random(&numbers), time = next_random(&numbers);
        uint from = (uint)((ulong)i * point_count / count);
        vec3 p = survey_points[from], d = from_local(make_frame(survey_normals[from]), warp_cosine_hemisphere(make_vec2(x, y)));
        uint texel = exit_guide_box(light_set.guide_box, p, d).texel;
        survey_texels[i] = is_blocked(g, tables, p, d, FAR_AWAY, time, no_aim()) ? NONE : min(texel, (uint)GUIDE_BOX_TEXELS);
    }
}
