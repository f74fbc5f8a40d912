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

/// Prepares a path guide, if the scene asks for one and its paths can use it. Call once it is known whether light paths are traced.
void packPathGuide(const PackContext& context, PackedScene& packed);
/// Does without it.
void dropPathGuide(PackedScene& packed);

}  // namespace eikonal
