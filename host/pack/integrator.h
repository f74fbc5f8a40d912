#pragma once
// The settings of light transport.

#include "pack/colors.h"

namespace eikonal {

/// What kinds of integrators write.
struct IntegratorPacking {
    const PackContext& context;
    settings& frame;
    ColorPacker& colors;
};

/// Fills in the integrator's settings; warns if it stands for another, and of media that it leaves out.
void packIntegrator(const IntegratorPacking&, bool hasUnusedMedia);

}  // namespace eikonal
