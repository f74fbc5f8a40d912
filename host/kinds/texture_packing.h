#pragma once
// Shared code for packing textures.

#include "kinds/texture_kind.h"
#include "pack/textures.h"
#include "scene/textures.h"

namespace eikonal {

/// What kinds of textures refer to.
struct TexturePacking {
    const PackContext& context;
    ColorPacker& colors;
    TexturePacker& textures;
    glm::dmat4 worldFromPoint;  ///< world space, where textures are placed, from the space of the points at which the program is evaluated
    bool unbounded = false;     ///< colours are not reflectances: they may exceed 1, and are upsampled to unbounded spectra
    bool leavesUnit = false;    ///< set by kinds: values may lie outside [0, 1]
};

/// Sets an instruction's mapping from points to texture coordinates.
void packMapping(const TexturePacking&, const Mapping&, texture_instruction& i);
/// The transform from the space of points to texture space, scaled.
affine textureFromScene(const TexturePacking&, const Mapping&, double scale = 1);
/// Sets an instruction's octaves of noise, evaluated in texture space.
void packOctaves(const TexturePacking&, const Texture&, texture_instruction& i);

}  // namespace eikonal
