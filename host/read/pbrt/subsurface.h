#pragma once
// What is inside of a body of material "subsurface", from the four ways in which a scene may say it.

#include "read/pbrt/arguments.h"
#include "read/pbrt/textures.h"

#include <memory>

namespace eikonal::pbrt {

/// Sets `interior`, `diffusion` and `method` of a material "subsurface", whose inputs have been read, from its `arguments`: "name", or "sigma_a" and "sigma_s", or
/// "reflectance" with "mfp" (scene/diffuse_albedo.h), or, given none of them, pbrt-v4's default; "scale" multiplies coefficients or the mean free path.
/// Warns of parameters that something else overrides. Throws SceneError if there is one sigma only, no such method, or no substance of that name. If a
/// texture says what is inside, there is no `interior`: walks need one that is the same everywhere.
void readInterior(Reading& reading, const Arguments& arguments, Material& material, TextureRegistry& textures);

}  // namespace eikonal::pbrt
