#pragma once
// What can be set before WorldBegin: tables of kinds and their parameters.

#include "read/pbrt/kinds.h"

#include <vector>

namespace eikonal::pbrt {

/// The tables of what can be set: cameras, films, pixel filters, samplers, integrators, accelerators.
std::vector<const KindTable*> settingKinds();

}  // namespace eikonal::pbrt
