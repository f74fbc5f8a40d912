/* vertex -> grid.  Makes the entry of each light vertex in its bucket of the hash grid. Before, the grid has the begin of each bucket;
   after, its end. Entries of a bucket arrive in any order. A tracing stage. */
#include "shade/light_vertices.clh"
#include "stages/stage.clh"

#define PLACE_VERTICES(TABLE, ARGUMENT) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, vertex) ARGUMENT(__global uint *, grid) \
    ARGUMENT(uint, grid_buckets)
TRACING_STAGE(place_vertices, PLACE_VERTICES) {
    for (size_t i = first_slot; i < SLOTS_END; ++i) {
        vertex_item v = load_vertex(vertex, 1, i * vertex_words);
        grid_item e = new_grid();
        e.p = v.p;
        e.vertex = (uint)i;
        e.pass = v.pass; e.number = v.number; e.depth = v.depth;
        store_entry(grid + grid_buckets, atomic_inc(grid + bucket_of(frame, v, grid_buckets)), e);
    }
}
