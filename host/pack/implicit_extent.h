#pragma once
// Where in its box an implicit surface is, and how large it is: for light samples.

#include "eikonal/shape.h"
#include "pack/space.h"

#include <span>

namespace eikonal {

/// A sphere that contains the surface, and its area. radius 0: there is no surface.
struct ImplicitExtent { glm::dvec3 center{0}; double radius = 0, area = 0; };

/// Of the surface within a box of object space, which m maps to the space of the result. The sphere is certain, and hardly larger than the
/// surface. The area is that of a mesh of up to 64 cells a side (marching tetrahedra: 0.2 % too small for a sphere that fills its box),
/// or, where a surface has too little thickness for such a mesh, an estimate by the number of cells that it may cross.
ImplicitExtent extentOf(std::span<const implicit_instruction> program, const Box& box, const glm::dmat4& m);

}  // namespace eikonal
