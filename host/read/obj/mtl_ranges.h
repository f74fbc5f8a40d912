#pragma once
// Which numbers mean something in a material library.

#include "diagnostics.h"
#include "read/obj/mtl.h"

namespace eikonal {

/// The material with numbers that mean something: a fraction is in [0, 1], for one. Others are replaced, with a warning at the first of a
/// statement that says by what. What is no number at all stays as it is, for whoever reads it.
MtlMaterial withinRanges(MtlMaterial material, Diagnostics& diagnostics);

}  // namespace eikonal
