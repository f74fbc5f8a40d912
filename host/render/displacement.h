#pragma once
// Meshes that a texture displaces, made what they are to be before a scene is packed. The texture is evaluated by the device
// (kernels/stages/displace_vertices.cl), with the same functions as everywhere.

#include "diagnostics.h"
#include "render/stages.h"
#include "scene/scene.h"

namespace eikonal {

/// Whether a shape of the scene has a displacement.
bool hasDisplacedMeshes(const Scene& scene);

/// Cuts their long edges, looks up the texture at each vertex (its place in world space when the motion starts, its texture coordinates),
/// and moves it; no shape has a displacement any more. The scene keeps the images that were loaded. Throws an Error that lists all meshes
/// that cannot be cut so short, or have normals or heights that are not finite; warns of a mesh without texture coordinates, which are (0,
/// 0) then.
void displaceMeshes(Scene& scene, const Context& context, Compiler& compiler, const StageShape& shape, const BuildSettings& settings,
                    Diagnostics& diagnostics);

}  // namespace eikonal
