// A metal, smooth or rough.

#include "kinds/material_packing.h"
#include "kinds/material_reading.h"

namespace eikonal {

static const MaterialDirective directives[] = {
    {"conductor",
     "spectrummap eta = metal-Cu-eta; spectrummap k = metal-Cu-k; colormap reflectance;"
     "floatmap uroughness | roughness = 0 clamped to [0, inf); floatmap vroughness | roughness = 0 clamped to [0, inf);"
     "bool energycompensation = false -> -; bool remaproughness = true -> -"},
};

static next_queue pack(InputWriter& in) {
    if (in.isSmooth()) {
        packMetal(in, slot_specular_conductor::eta, slot_specular_conductor::k);
        return next_specular_conductor;
    }
    if (in.compensatesEnergy()) {
        in.lostEnergy(slot_compensated_conductor::energy);
        packMetal(in, slot_compensated_conductor::eta, slot_compensated_conductor::k);
        in.widths(slot_compensated_conductor::alpha_x, slot_compensated_conductor::alpha_y);
        return next_compensated_conductor;
    }
    packMetal(in, slot_conductor::eta, slot_conductor::k);
    in.widths(slot_conductor::alpha_x, slot_conductor::alpha_y);
    return next_conductor;
}

const MaterialKind conductor_material{
    .directives = directives, .read = pbrt::readEnergyCompensation, .pack = pack, .metalIndices = {"eta", "k"}};

}  // namespace eikonal
