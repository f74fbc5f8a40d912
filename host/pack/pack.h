#pragma once
// From a scene's description to the device's tables.

#include "diagnostics.h"
#include "pack/tables.h"
#include "scene/scene.h"

#include <span>
#include <vector>

namespace eikonal {

/// Loads the scene's images, moves everything to scene space, builds the hierarchy and fills every table.
/// Throws SceneError for what the description cannot mean; warns about what is left out.
PackedScene packScene(const Scene& scene, Diagnostics& diagnostics);

/// Textures of a scene without the rest of it, for points in world space. programs[i] is that of textures[i]. Throws as packScene.
struct PackedTextures { PackedScene scene; std::vector<uint> programs; };
PackedTextures packTextures(const Scene& scene, std::span<const int> textures, Diagnostics& diagnostics);

}  // namespace eikonal
