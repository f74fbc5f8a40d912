#pragma once
// Shapes as the device sees them, and what bounds their elements.

#include "pack/group.h"
#include "pack/packer.h"

namespace eikonal {

/// Adds a shape to a group, and to the tables: unless it has no elements, or is an interface that nothing asks about.
/// `inObject`: of an object, where area lights do not emit. `instanceSwaps`: worldFromObject
/// has an instance's transform in it, which swaps handedness. `id`: what the channel of objects shows.
void packShape(Packer&, Group&, const Shape&, const glm::dmat4& worldFromObject, bool inObject, bool instanceSwaps, uint id);

}  // namespace eikonal
