#pragma once
// Ranges of the numbers in a material library.

#include "diagnostics.h"
#include "read/obj/mtl.h"

namespace eikonal {

/// Replaces numbers out of their range, such as fractions outside [0, 1], with a warning at the first number of each statement. Words that
/// are not numbers are kept for the parser of the statement. Warns of words after the last number, which do not count.
MtlMaterial withinRanges(MtlMaterial material, Diagnostics& diagnostics);

}  // namespace eikonal
