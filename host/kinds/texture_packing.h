#pragma once
// Shared code for packing textures.

#include "kinds/texture_kind.h"
#include "pack/textures.h"
#include "scene/textures.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

/// The smallest change of (u, v) and the smallest distance between points, in their space, at which a texture may have other values.
/// Infinite: there is none.
struct TextureDetail { double uv = HUGE_VAL, distance = HUGE_VAL; };

/// What kinds of textures refer to.
struct TexturePacking {
    const PackContext& context;
    ColorPacker& colors;
    TexturePacker& textures;
    glm::dmat4 worldFromPoint;  ///< world space, where textures are placed, from the space of the points at which the program is evaluated
    bool unbounded = false;     ///< colours are not reflectances: they may exceed 1, and are upsampled to unbounded spectra
    bool leavesUnit = false;    ///< set by kinds: values may lie outside [0, 1]
    TextureDetail detail;       ///< set by kinds

    void addDetail(TextureDetail other) {
        detail = {std::min(detail.uv, other.uv), std::min(detail.distance, other.distance)};
    }
};

/// Sets an instruction's mapping from points to texture coordinates.
void packMapping(const TexturePacking&, const Mapping&, texture_instruction& i);
/// The transform from the space of points to texture space, scaled.
affine textureFromScene(const TexturePacking&, const Mapping&, double scale = 1);
/// Sets an instruction's octaves of noise, evaluated in texture space.
void packOctaves(TexturePacking&, const Texture&, texture_instruction& i);

}  // namespace eikonal
