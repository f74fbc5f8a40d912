/* hit -> cached.  Keeps the hits of light paths that paths from the camera can connect with: those in media and on rough surfaces, of some
   of the paths (shade/cached_hits.clh). Appends records in any order, and puts each at the end of its path's list. A counting stage, built
   once per BSDF. */
#include "bsdf/bsdf_names.clh"
#include "shade/cached_hits.clh"
#include "bsdf/bsdf.clh"
#include "eikonal/stages.h"
#include "stages/stage.clh"

FN int caches_hit(__global const settings *frame, hit_item h) {
    return keeps_hit(frame->cached_share, h) && h.number >> frame->cached_share < cached_paths(frame);
}

#define CACHE_HITS(TABLE, ARGUMENT) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, hit) ARGUMENT(__global uint *, cached) \
    ARGUMENT(__global uint *, cached_hit) ARGUMENT(uint, cached_hit_size) ARGUMENT(__global uint *, cached_last) \
    ARGUMENT(__global uint *, cached_count) ARGUMENT(uint, cached_capacity) ARGUMENT(uint, cached_pass_mask) ARGUMENT(uint, first)
COUNTING_STAGE(cache_hits, CACHE_HITS) {
    if (BSDF_IS_DELTA) return;
    uint kept = 0;
    for (size_t at = first_slot; at < COUNTING_SLOTS_END; ++at) kept += caches_hit(frame, load_hit(hit, capacity, first + at)) ? 1u : 0u;
    if (!kept) return;
    uint to = atomic_add(cached_count, kept);
    for (size_t at = first_slot; at < COUNTING_SLOTS_END && to < cached_capacity; ++at) {
        size_t i = first + at;
        hit_item h = load_hit(hit, capacity, i);
        if (!caches_hit(frame, h)) continue;
        cached_item c = new_cached();
        c.p = h.p; c.offset = h.offset; c.depth = h.depth;
        c.ng = face_forward(h.ng, h.wo);
        c.ns = face_forward(h.ns, h.wo);
        c.secondary_terminated = h.secondary_terminated;
        c.bsdf = JOIN(next_, BSDF);
        h.beta = mul(h.beta, 1.0f / kept_share(h.depth));
        c.power = max_component(h.beta) / (HAS_MEDIA ? max1(mean_component(h.r_u), 1e-30f) : 1.0f);
        c.by_camera_paths = found_from_other_side(h, even_pdf(h.ng, h.wo));
        __global uint *last = cached_last + cached_path(frame, cached_pass_mask, h.number >> frame->cached_share, h.pass);
        c.before = *last;
        size_t record = cached_hit_at(cached_hit_size, to);
        store_hit(cached_hit, 1, record, h);
        for (uint word = hit_words; word < hit_words + JOIN(BSDF, _words); ++word) cached_hit[record + word] = hit[word * capacity + i];
        store_cached(cached, to, c);
        *last = ++to;
    }
}
