/* emission -> path.  Adds what the surfaces that were hit emit. Straight-line. */
#include "emission.clh"
#include "scene.clh"

STAGE shade_emitters(__global const uint *emission, __global uint *path, uint capacity, uint path_capacity, uint count) {
    FOR_EACH_SLOT(i, count) {
        emission_item e = load_emission(emission, capacity, i);
        spectrum L = weigh_emission(e.beta, e.Le, e.r_u, e.r_l, e.pdf, e.pdf_light);
        add_radiance(path, path_capacity, i < count ? e.path : NOBODYS_PATH(i), L);
    }
}
