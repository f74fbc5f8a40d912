/* grid -> grid.  Sorts the entries of each bucket, so that sums over them do not depend on when light paths arrived. Shell's sort, since
   most buckets have few entries, and some thousands. A tracing stage. */
#include "shade/light_vertices.clh"
#include "stages/stage.clh"

FN int is_before(grid_item a, grid_item b) {
    if (a.pass != b.pass) return a.pass < b.pass;
    return a.number != b.number ? a.number < b.number : a.depth < b.depth;
}

#define ORDER_VERTICES(TABLE, ARGUMENT) ARGUMENT(__global uint *, grid) ARGUMENT(uint, grid_buckets)
TRACING_STAGE(order_vertices, ORDER_VERTICES) {
    for (size_t bucket = first_slot; bucket < SLOTS_END; ++bucket) {
        uint begin = bucket ? grid[bucket - 1] : 0u, entries = grid[bucket] - begin;
        __global uint *entry = grid + grid_buckets + (size_t)begin * grid_words;
        for (uint gap = entries / 2u; gap > 0u; gap = gap == 2u ? 1u : gap * 5u / 11u)
            for (uint i = gap; i < entries; ++i) {
                grid_item e = load_entry(entry, i);
                uint to = i;
                for (; to >= gap && is_before(e, load_entry(entry, to - gap)); to -= gap)
                    store_entry(entry, to, load_entry(entry, to - gap));
                store_entry(entry, to, e);
            }
    }
}
