// A dielectric such as glass, smooth or rough.

#include "kinds/material_packing.h"
#include "kinds/material_reading.h"

namespace eikonal {

static const MaterialDirective directives[] = {
    {"dielectric",
     "index eta = 1.5 in [0, inf); floatmap uroughness | roughness = 0 clamped to [0, inf); floatmap vroughness | roughness = 0 clamped to "
     "[0, inf);"
     "bool energycompensation = false -> -; bool remaproughness = true -> -"},
};

static next_queue pack(InputWriter& in) {
    in.transmit();
    in.beClear();
    if (in.isSmooth()) {
        in.index(slot_specular_dielectric::eta, "eta");
        return next_specular_dielectric;
    }
    if (in.compensatesEnergy()) {
        in.lostEnergy(slot_compensated_dielectric::energy, "eta");
        in.index(slot_compensated_dielectric::eta, "eta");
        in.widths(slot_compensated_dielectric::alpha_x, slot_compensated_dielectric::alpha_y);
        return next_compensated_dielectric;
    }
    in.index(slot_dielectric::eta, "eta");
    in.widths(slot_dielectric::alpha_x, slot_dielectric::alpha_y);
    return next_dielectric;
}

const MaterialKind dielectric_material{.directives = directives, .read = pbrt::readEnergyCompensation, .pack = pack};

}  // namespace eikonal
