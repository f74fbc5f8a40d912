#pragma once
// Shared code for packing textures.

#include "kinds/texture_kind.h"
#include "pack/packer.h"
#include "scene/textures.h"

namespace eikonal {

/// What a texture is packed into.
struct TexturePacking {
    Packer& packer;
    bool unbounded = false;     ///< colours are not reflectances: they may exceed 1, and are upsampled to unbounded spectra
    bool leavesUnit = false;    ///< set by kinds: values may lie outside [0, 1]
};

/// Sets an instruction's mapping from points to texture coordinates.
void packMapping(const Packer&, const Mapping&, texture_instruction& i);
/// The transform from scene space to texture space, scaled.
affine textureFromScene(const Packer&, const Mapping&, double scale = 1);
/// Sets an instruction's octaves of noise, evaluated in texture space.
void packOctaves(const Packer&, const Texture&, texture_instruction& i);

}  // namespace eikonal
