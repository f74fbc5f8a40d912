// Scatters light equally in all directions.

#include "kinds/material_packing.h"

namespace eikonal {

static const MaterialDirective directives[] = {
    {"diffuse", "colormap reflectance = 0.5"},
};

static next_queue pack(InputWriter& in) {
    in.spectrum(slot_diffuse::reflectance, "reflectance");
    return next_diffuse;
}

const MaterialKind diffuse_material{.directives = directives, .pack = pack};

}  // namespace eikonal
