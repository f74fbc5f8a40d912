/* hit, vertex, grid -> path.  Adds the light of the light paths of the same pass whose vertices are near (shade/merge_vertex.clh). A
   tracing stage, built once per BSDF, over that BSDF's segment of the hit queue. */
#include "stages/stage.clh"
#include "bsdf/bsdf_names.clh"
#include "shade/merge_vertex.clh"
#include "shade/render_pass.clh"

#define MERGE_VERTICES(TABLE, ARGUMENT) \
    BSDF_TABLES(TABLE) COLOR_TABLES(TABLE) INTERRUPT_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, hit) ARGUMENT(__global const uint *, vertex) \
    ARGUMENT(__global const uint *, grid) ARGUMENT(uint, grid_buckets) ARGUMENT(__global uint *, path) ARGUMENT(uint, first)
TRACING_STAGE(merge_vertices, MERGE_VERTICES) {
    if (BSDF_IS_DELTA) return;
    bsdf_tables bsdf_set = BIND_BSDFS;
    color_tables color_set = BIND_COLORS;
    for (size_t at = first_slot; at < SLOTS_END; ++at) {
        if (is_interrupted(stop)) return;
        size_t i = first + at;
        hit_item h = load_hit(hit, capacity, i);
        if (h.merging == 0.0f || counted_events(h) >= frame->max_depth) continue;
        BSDF_BOUND b = BIND_BSDF(h, LOAD_BSDF(hit, capacity, i), bsdf_set, color_set);
        merged_light L = merge_hit(frame, vertex, grid, grid_buckets, h, b);
        if (is_black(L.all)) continue;
        add_to_spectrum(path, path_L_slot, path_capacity, h.path, L.all);
        add_to_pass(path, path_capacity, h.path, L.straight, h.render_pass);
        add_to_pass(path, path_capacity, h.path, L.bounced, pass_behind_surface(h.render_pass));
    }
}
