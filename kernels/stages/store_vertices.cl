/* hit -> vertex.  Stores the vertices of light paths that paths from the camera can merge with: those on surfaces that are not smooth, of
   some of the paths (shade/light_vertices.clh). Appends, so in any order. A counting stage, built once per BSDF. */
#include "bsdf/bsdf_names.clh"
#include "shade/light_vertices.clh"
#include "bsdf/bsdf.clh"
#include "eikonal/stages.h"
#include "stages/stage.clh"

FN int stores_hit(__global const settings *frame, hit_item h) {
    return h.merging > 0.0f && keeps_hit(frame->stored_share, h);
}

#define STORE_VERTICES(TABLE, ARGUMENT) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, hit) ARGUMENT(__global uint *, vertex) \
    ARGUMENT(__global uint *, vertex_count) ARGUMENT(uint, vertex_capacity) ARGUMENT(uint, first)
COUNTING_STAGE(store_vertices, STORE_VERTICES) {
    if (BSDF_IS_DELTA) return;
    uint stored = 0;
    for (size_t at = first_slot; at < COUNTING_SLOTS_END; ++at) stored += stores_hit(frame, load_hit(hit, capacity, first + at)) ? 1u : 0u;
    if (!stored) return;
    uint to = atomic_add(vertex_count, stored);
    for (size_t at = first_slot; at < COUNTING_SLOTS_END; ++at) {
        hit_item h = load_hit(hit, capacity, first + at);
        if (!stores_hit(frame, h)) continue;
        vertex_item v = new_vertex();
        v.p = h.p; v.ng = h.ng; v.wo = h.wo;
        v.beta = mul(h.beta, 1.0f / (kept_share(h.depth) * h.merging_chance));
        v.r_u = h.r_u;
        v.d_vcm = h.d_vcm; v.d_vc = h.d_vc;
        v.secondary_terminated = h.secondary_terminated;
        v.render_pass = h.render_pass;
        v.number = h.number; v.pass = h.pass; v.depth = h.depth;
        if (to < vertex_capacity) store_vertex(vertex, 1, (size_t)to * vertex_words, v);
        ++to;
    }
}
