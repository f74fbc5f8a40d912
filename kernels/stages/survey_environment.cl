/* Measures how much light comes through each opening of the environment guide to each of its maps. A map has `representatives` points with
   normals; each casts one ray at a random place in each opening. A normal of zero length stands for points that gather light from all
   directions. survey_weights: two floats for each opening of each map: the sum over the rays that nothing blocks, and over all rays, of
   what an environment of radiance 1 adds through the opening to the irradiance (or fluence), each at most pi. Runs before a render
   (host/render/survey.cpp). */
#include "trace/bvh.clh"
#include "light/light.clh"
#include "math/random.clh"
#include "stages/stage.clh"

#define SURVEY_ENVIRONMENT(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) LIGHT_TABLES(TABLE) \
    ARGUMENT(__global const vec3 *, survey_points) ARGUMENT(__global const vec3 *, survey_normals) \
    ARGUMENT(__global float *, survey_weights) \
    ARGUMENT(uint, representatives)
TRACING_STAGE(survey_environment, SURVEY_ENVIRONMENT) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    light_tables light_set = BIND_LIGHTS;
    for (uint i = (uint)first_slot; i < SLOTS_END; ++i) {
        uint map = i / GUIDE_OPENINGS;
        guide_opening o = fetch_opening(light_set.guide_openings + i % GUIDE_OPENINGS);
        random_stream numbers = make_stream(1u, i, 0u);
        float seen = 0.0f, possible = 0.0f;
        for (uint k = map * representatives; k < (map + 1u) * representatives && o.inverse_area > 0.0f; ++k) {
            float x = next_random(&numbers), y = next_random(&numbers), time = next_random(&numbers);
            vec3 p = survey_points[k], n = survey_normals[k], to = sub(mul_add(o.a, x, mul_add(o.b, y, o.corner)), p);
            float d2 = max1(dot3(to, to), 1e-30f), inverse = 1.0f / sqrt(d2);
            vec3 d = mul(to, inverse);
            float cosine = length_squared(n) > 0.0f ? dot3(n, d) : 1.0f, arriving = cosine * dot3(o.n, d) / (d2 * o.inverse_area);
            if (!(cosine > 0.0f && arriving > 0.0f)) continue;
            arriving = min1(arriving, PI);
            possible += arriving;
            seen += is_blocked(g, tables, p, d, FAR_AWAY, time, no_aim()) ? 0.0f : arriving;
        }
        survey_weights[2u * i] = seen;
        survey_weights[2u * i + 1u] = possible;
    }
}
