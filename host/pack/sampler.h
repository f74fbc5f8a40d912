#pragma once
// The sampler: which sequences the random numbers of paths come from.

#include "pack/context.h"

namespace eikonal {

void packSampler(const PackContext&, settings& frame);

}  // namespace eikonal
