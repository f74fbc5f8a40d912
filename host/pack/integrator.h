#pragma once
// The settings of the integrator.

#include "pack/colors.h"

namespace eikonal {

/// What kinds of integrators write.
struct IntegratorPacking {
    const PackContext& context;
    settings& frame;
    ColorPacker& colors;
};

/// Fills in the integrator's settings. Warns if it replaces another one, and if it ignores media.
void packIntegrator(const IntegratorPacking&, bool hasUnusedMedia);

}  // namespace eikonal
