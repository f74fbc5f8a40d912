#pragma once
// From a scene's description to the device's tables.

#include "diagnostics.h"
#include "pack/hierarchies.h"
#include "scene/scene.h"

#include <span>
#include <vector>

namespace eikonal {

/// A scene whose tables are filled and whose features are known, but for the hierarchies over its shapes (Hierarchies::build).
struct Packing { PackedScene scene; Hierarchies hierarchies; };

/// Loads the scene's images, moves everything to scene space and fills the tables. What is left to do needs nothing of the description.
/// Throws SceneError for what the description cannot mean; warns about what is left out.
Packing packTables(const Scene& scene, Diagnostics& diagnostics);

/// The same with its hierarchies.
PackedScene packScene(const Scene& scene, Diagnostics& diagnostics);

/// Textures of a scene without the rest of it, for points in world space. programs[i] is that of textures[i]. Throws as packScene.
struct PackedTextures { PackedScene scene; std::vector<uint> programs; };
PackedTextures packTextures(const Scene& scene, std::span<const int> textures, Diagnostics& diagnostics);

/// Has paths of a scene with these settings ended by a rule.
void setRoulette(settings& frame, const Roulette& roulette);

}  // namespace eikonal
