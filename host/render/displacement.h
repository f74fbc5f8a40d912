#pragma once
// Displaces meshes before the scene is packed. The device evaluates the textures (kernels/stages/displace_vertices.cl), with the same
// functions as the stages.

#include "diagnostics.h"
#include "render/stages.h"
#include "scene/scene.h"

namespace eikonal {

/// Whether a shape of the scene has a displacement.
bool hasDisplacedMeshes(const Scene& scene);

/// Splits long edges, evaluates the texture at each vertex (at its world position at the start of the motion, and its texture coordinates),
/// moves the vertices, and removes the shapes' displacements. Loaded images stay in the scene. Throws an Error that lists all meshes whose
/// edges cannot be split, or whose normals or displaced positions are not finite. Warns of meshes without texture coordinates, which count
/// as (0, 0).
void displaceMeshes(Scene& scene, const Context& context, Compiler& compiler, const StageShape& shape, const BuildSettings& settings,
                    Diagnostics& diagnostics);

}  // namespace eikonal
