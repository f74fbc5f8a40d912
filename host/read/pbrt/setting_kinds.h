#pragma once
// Tables of the kinds that are allowed before WorldBegin, and their parameters.

#include "read/pbrt/kinds.h"

#include <vector>

namespace eikonal::pbrt {

/// The tables of cameras, films, pixel filters, samplers, integrators and accelerators.
std::vector<const KindTable*> settingKinds();

/// The options of Option directives, by pbrt-v4's plain names. Each has a single parameter, which has the option's name.
const KindTable& optionKinds();

}  // namespace eikonal::pbrt
