#pragma once
// Tables of the kinds that are allowed before WorldBegin, and their parameters.

#include "read/pbrt/kinds.h"

#include <vector>

namespace eikonal::pbrt {

/// The tables of cameras, films, pixel filters, samplers, integrators and accelerators.
std::vector<const KindTable*> settingKinds();

}  // namespace eikonal::pbrt
