/* vertex -> grid.  Counts the light vertices of each bucket of the hash grid. A tracing stage. */
#include "shade/light_vertices.clh"
#include "stages/stage.clh"

#define COUNT_VERTICES(TABLE, ARGUMENT) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, vertex) ARGUMENT(__global uint *, grid) \
    ARGUMENT(uint, grid_buckets)
TRACING_STAGE(count_vertices, COUNT_VERTICES) {
    for (size_t i = first_slot; i < SLOTS_END; ++i)
        atomic_inc(grid + bucket_of(frame, load_vertex(vertex, 1, i * vertex_words), grid_buckets));
}
