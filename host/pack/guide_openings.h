#pragma once
// The openings of the environment guide (include/eikonal/light.h): where the light of an environment enters a scene.

#include "eikonal/portable.h"
#include "pack/tables.h"

#include <span>

namespace eikonal {

/// Sets the guide's box: along each axis, the bounds of the middle 98 % of `points` (scene space), which must not be empty, and a margin.
void packGuideBox(LightTables& tables, std::span<const vec3> points);

/// Fills guide_openings and guide_texels. `exits`: the texel of the box through which each of many rays leaves; GUIDE_BOX_TEXELS: it misses
/// the box; NONE: a surface stops it.
/// Openings become smaller where more rays leave; up to GUIDE_OPENINGS of them together contain all texels with a ray and those around
/// these. Sorted so that neighbours in the list are neighbours on the box.
void packGuideOpenings(LightTables& tables, std::span<const uint> exits);

/// No openings.
void packNoGuideOpenings(LightTables& tables);

}  // namespace eikonal
