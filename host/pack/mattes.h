#pragma once
// The names of objects and materials, for Cryptomatte.

#include "pack/tables.h"
#include "scene/scene.h"

namespace eikonal {

/// Fills the tables and the manifests of those layers of Cryptomatte that the packed scene requires. Names: of an instance, that of its
/// object; of a shape, its own, else its kind and place, "sphere@scene.pbrt:12"; of a material likewise; of pbrt's default material,
/// "default".
void packMattes(const Scene& scene, PackedScene& packed);

}  // namespace eikonal
