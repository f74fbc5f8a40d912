#pragma once
// From a scene's description to the device's tables.

#include "diagnostics.h"
#include "pack/hierarchies.h"
#include "scene/scene.h"

#include <span>
#include <vector>

namespace eikonal {

/// A scene with all tables and features, and its hierarchies, yet to be built (Hierarchies::build).
struct Packing { PackedScene scene; Hierarchies hierarchies; };

/// Loads the scene's images, moves everything to scene space and fills the tables. The description is not needed afterwards.
/// Throws SceneError for an invalid description; warns about what is left out.
Packing packTables(const Scene& scene, Diagnostics& diagnostics);

/// The same, with the hierarchies built.
PackedScene packScene(const Scene& scene, Diagnostics& diagnostics);

/// Only textures of a scene, for points in world space. programs[i] is the program of textures[i]. Throws as packScene.
struct PackedTextures { PackedScene scene; std::vector<uint> programs; };
PackedTextures packTextures(const Scene& scene, std::span<const int> textures, Diagnostics& diagnostics);

/// Sets the rule of Russian roulette.
void setRoulette(settings& frame, const Roulette& roulette);

}  // namespace eikonal
