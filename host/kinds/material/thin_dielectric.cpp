// A thin dielectric sheet, such as a pane of glass.

#include "kinds/material_packing.h"

namespace eikonal {

static const MaterialDirective directives[] = {
    {"thindielectric", "index eta = 1.5 in [0, inf)"},
};

static next_queue pack(InputWriter& in) {
    in.beClear();
    in.index(slot_thin_dielectric::eta, "eta");
    return next_thin_dielectric;
}

const MaterialKind thin_dielectric_material{.directives = directives, .pack = pack};

}  // namespace eikonal
