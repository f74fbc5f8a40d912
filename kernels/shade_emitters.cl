/* emission -> path.  Adds what the surfaces that were hit emit. Straight-line. */
#include "emission.clh"
#include "scene.clh"

STAGE shade_emitters(__global const uint *emission, __global uint *path, uint capacity, uint count) {
    size_t i = get_global_id(0);
    emission_item e = load_emission(emission, capacity, i);
    spectrum L = weigh_emission(e.beta, e.Le, e.r_u, e.r_l, e.pdf, e.pdf_light);
    size_t p = i < count ? e.path : capacity - LOCAL_SIZE + get_local_id(0);
    add_radiance(path, capacity, p, L);
}
