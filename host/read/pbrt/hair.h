#pragma once
// What hair absorbs, from the several ways in which a scene may say it.

#include "read/pbrt/arguments.h"
#include "read/pbrt/textures.h"

namespace eikonal::pbrt {

/// The inputs "sigma_a" and "h" of material "hair", whose parameters are `arguments`: of "sigma_a", "reflectance" (or "color") and the melanins
/// the first that is given counts, as in pbrt-v4; warns of the others. None of them: brown hair.
void readHair(Reading& reading, TextureRegistry& textures, const Arguments& arguments, Material& material);

}  // namespace eikonal::pbrt
