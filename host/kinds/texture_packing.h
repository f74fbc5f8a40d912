#pragma once
// What kinds of textures share when they are packed.

#include "kinds/texture_kind.h"
#include "pack/packer.h"
#include "scene/textures.h"

namespace eikonal {

/// What a texture is packed into.
struct TexturePacking {
    Packer& packer;
    bool unbounded = false;     ///< its colours are no reflectances: they may be larger than 1, and are made spectra as such
    bool leavesUnit = false;    ///< set by kinds: some value may lie outside of [0, 1]
};

/// Lets an instruction map points to texture coordinates.
void packMapping(const Packer&, const Mapping&, texture_instruction& i);
/// From scene space to the texture's own space, scaled.
affine textureFromScene(const Packer&, const Mapping&, double scale = 1);
/// Lets an instruction sum octaves of noise in the texture's own space.
void packOctaves(const Packer&, const Texture&, texture_instruction& i);

}  // namespace eikonal
