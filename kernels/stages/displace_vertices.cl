/* Evaluates a displacement texture at each vertex of a mesh. Runs before the scene is packed, so it is not among the stages of a wave
   (host/render/displacement.cpp). */
#include "stages/stage.clh"
#include "texture/texture.clh"

#define DISPLACE_VERTICES(TABLE, ARGUMENT) \
    TEXTURE_TABLES(TABLE) \
    ARGUMENT(__global const vec3 *, vertex_points) ARGUMENT(__global const vec3 *, vertex_normals) \
    ARGUMENT(__global const vec2 *, vertex_uvs) \
    ARGUMENT(uint, program) ARGUMENT(__global float *, heights)
TRACING_STAGE(displace_vertices, DISPLACE_VERTICES) {
    texture_tables tables = BIND_TEXTURES;
    for (size_t i = first_slot; i < SLOTS_END; ++i) {
        texture_point at = {vertex_points[i], vertex_normals[i], vertex_uvs[i]};
        heights[i] = eval_number(tables, program, &at);
    }
}
