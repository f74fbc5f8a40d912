#pragma once
// From a material to the parameters of its BSDF.

#include "pack/material_inputs.h"

namespace eikonal {

/// Writes the parameters, and says which BSDF they are of: a smooth material has another than a rough one. For interfaces and mixes, what those do.
next_queue packBsdf(InputWriter&, MaterialKind);

}  // namespace eikonal
