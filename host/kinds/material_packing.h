#pragma once
// What kinds of materials share when they are packed.

#include "kinds/material_kind.h"
#include "pack/material_inputs.h"

namespace eikonal {

/// A metal's indices: measured, textured, or those that give a reflectance at normal incidence (pbrt-v4: eta = 1). Measured ones are
/// fitted to what the metal reflects in a medium of index `around`.
void packMetal(InputWriter& in, uint etaSlot, uint kSlot, const char* eta = "eta", const char* k = "k", double around = 1);

}  // namespace eikonal
