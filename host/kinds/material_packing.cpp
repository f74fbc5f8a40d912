#include "kinds/material_packing.h"

namespace eikonal {

void packMetal(InputWriter& in, uint etaSlot, uint kSlot, const char* eta, const char* k, double around) {
    if (in.has("reflectance")) {
        in.constant(etaSlot, 1);
        in.metal(kSlot, "reflectance");
    } else if (in.isSpectral() || in.get(eta).texture != none || in.get(k).texture != none) {
        in.coefficient(etaSlot, eta);
        in.coefficient(kSlot, k);
    } else {
        const ConductorIndices metal = conductorIndices(in.get(eta).value * (1 / around), in.get(k).value * (1 / around));
        in.spectrum(etaSlot, metal.eta * around);
        in.spectrum(kSlot, metal.k * around);
    }
}

}  // namespace eikonal
