#pragma once
// Shared code for packing materials.

#include "kinds/material_kind.h"
#include "pack/material_inputs.h"
#include "pack/material_slots.h"

namespace eikonal {

/// Packs a conductor's eta and k: measured, textured, or those that give a reflectance at normal incidence (with eta = 1, as in pbrt-v4).
/// Measured spectra are fitted to the reflectance in a medium of index `around`.
void packMetal(InputWriter& in, uint etaSlot, uint kSlot, const char* eta = "eta", const char* k = "k", double around = 1);

}  // namespace eikonal
