#pragma once
// In which order rays visit the children of a node.

#include "eikonal/bvh.h"

namespace eikonal {

/// Sets the node's `order` from its boxes: in each octant, by the distance of their centres along the octant's diagonal. So rays need not
/// sort children (after Fuetterling et al. 2017, "Accelerated single ray tracing for wide vector units").
void orderChildren(bvh_node& node);

}  // namespace eikonal
