/* emission -> path.  Adds the emission of the surfaces hit. Straight-line. */
#include "shade/emission.clh"
#include "stages/stage.clh"

#define SHADE_EMITTERS(TABLE, ARGUMENT) \
    ARGUMENT(__global const uint *, emission) ARGUMENT(__global uint *, path)
STAGE(shade_emitters, SHADE_EMITTERS) {
    FOR_EACH_SLOT_OF_GROUP(i, count) {
        emission_item e = load_emission(emission, capacity, i);
        size_t at = i < count ? e.path : DISCARDED_PATH(i);
        spectrum L = shade_emission(e);
        add_radiance(path, path_capacity, at, L, i < count ? e.render_pass : 0u);
        add_to_group(path, path_capacity, at, L, i < count ? e.group : 0u);
    }
}
