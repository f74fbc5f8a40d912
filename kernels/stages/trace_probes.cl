/* ray, probe -> intersection, exit_point, slot i to slot i.  Finds where paths leave the subsurface bodies that they entered. A
   tracing stage; rays without a probe are skipped. */
#include "trace/probe.clh"
#include "stages/stage.clh"

#define TRACE_PROBES(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) MATERIAL_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const uint *, ray) ARGUMENT(__global const uint *, probe) ARGUMENT(__global uint *, intersection) \
    ARGUMENT(__global uint *, exit_point)
TRACING_STAGE(trace_probes, TRACE_PROBES) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    material_tables material_set = BIND_MATERIALS;
    color_tables color_set = BIND_COLORS;
    for (size_t i = first_slot; i < SLOTS_END; ++i) {
        if (LOAD_FIELD(ray, float, t_max, ray, capacity, i) < 0.0f) continue;
        ray_item r = load_ray(ray, capacity, i);
        if (r.probe == NONE) continue;
        traced_probe found = trace_probe(g, tables, material_set, color_set, r, load_probe(probe, capacity, r.probe));
        store_intersection(intersection, capacity, i, found.intersection);
        store_exit_point(exit_point, capacity, i, found.exit);
    }
}
