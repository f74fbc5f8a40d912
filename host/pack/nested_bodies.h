#pragma once
// Subsurface bodies in one another.

namespace eikonal {

struct PackContext;

/// Warns if more bodies with a random walk lie in one another than a path remembers the surroundings of (MOST_NESTED_BODIES), by their
/// bounds. Not where there are more than 1000 bodies.
void warnOfNestedBodies(const PackContext& context);

}  // namespace eikonal
