/* Finds points that camera paths reach: the first SURVEY_VERTICES vertices of each path, with their normals. Runs before a render, so it is
   not among the stages of a wave (host/render/survey.cpp). Paths start uniformly over the image, pass straight through dielectric
   interfaces, and leave all other surfaces in a cosine-distributed direction. Unused entries get a normal of zero length. */
#include "camera/camera.clh"
#include "trace/intersect_ray.clh"
#include "trace/route_items.clh"
#include "stages/stage.clh"

/* A path ends after so many interfaces that it passes straight, dielectric and null ones, more than it has vertices to find. */
#define MOST_SURVEY_CROSSINGS 8

#define SURVEY_VERTICES_ARGUMENTS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) MATERIAL_TABLES(TABLE) CAMERA_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global vec3 *, survey_points) ARGUMENT(__global vec3 *, survey_normals)
TRACING_STAGE(survey_vertices, SURVEY_VERTICES_ARGUMENTS) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    material_tables material_set = BIND_MATERIALS;
    camera_tables camera_set = BIND_CAMERA;
    for (uint path = (uint)first_slot; path < SLOTS_END; ++path) {
        random_stream numbers = make_stream(0u, path, 0u);
        uint x = (uint)(next_random(&numbers) * (float)frame->width), y = (uint)(next_random(&numbers) * (float)frame->height);
        ray_item r = generate_ray(camera_set, frame, min(x, frame->width - 1u), min(y, frame->height - 1u), 0u, path).ray;
        uint found = 0u;
        for (int step = 0; step < SURVEY_VERTICES + MOST_SURVEY_CROSSINGS && found < SURVEY_VERTICES && r.t_max >= 0.0f; ++step) {
            intersection_item f = intersect_ray(g, tables, r);
            if (f.element == NONE) break;
            surface s = intersection_surface(g, tables, r, f);
            vec3 n = face_forward(s.ns, negate(r.d)), away = n;
            if (material_set.materials[g.shapes[g.element_shapes[f.element]].material].is_clear) away = r.d;
            else {
                uint at = path * SURVEY_VERTICES + found++;
                survey_points[at] = offset_origin(s.p, surface_offset(s), s.ng, n);
                survey_normals[at] = n;
                vec2 u = make_vec2(next_random(&numbers), next_random(&numbers));
                away = from_local(make_frame(n), warp_cosine_hemisphere(u));
            }
            r.o = offset_origin(s.p, surface_offset(s), s.ng, away);
            r.d = away;
            r.t_max = FAR_AWAY;
        }
        for (; found < SURVEY_VERTICES; ++found) survey_normals[path * SURVEY_VERTICES + found] = make_vec3(0.0f, 0.0f, 0.0f);
    }
}
