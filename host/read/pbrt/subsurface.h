#pragma once
// The interior of material "subsurface", from its four alternative sets of parameters.

#include "read/pbrt/arguments.h"
#include "read/pbrt/textures.h"

#include <memory>

namespace eikonal::pbrt {

/// Sets `interior`, `diffusion` and `method` of a material "subsurface", whose inputs have been read, from its `arguments`: "name"; or
/// "sigma_a" and "sigma_s"; or "reflectance" with "mfp" (color/diffuse_albedo.h); or else pbrt-v4's default. "scale" multiplies the
/// coefficients or the mean free path. Warns of parameters that are overridden. Throws SceneError if only one sigma is given, or for an
/// unknown method or substance. If a texture gives the interior, `interior` stays null, because random walks need a homogeneous one.
void readInterior(Reading& reading, const Arguments& arguments, Material& material, TextureRegistry& textures);

}  // namespace eikonal::pbrt
