#pragma once
// The sampler: which sequences the paths take their numbers from.

#include "pack/context.h"

namespace eikonal {

void packSampler(const PackContext&, settings& frame);

}  // namespace eikonal
