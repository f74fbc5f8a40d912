#pragma once
// The absorption of hair, from the alternative parameters of the material.

#include "read/pbrt/arguments.h"
#include "read/pbrt/textures.h"

namespace eikonal::pbrt {

/// Sets the inputs "sigma_a" and "h" of material "hair" from `arguments`. Of "sigma_a", "reflectance" (or "color") and the melanins the
/// first that is given counts, as in pbrt-v4, with a warning for the others; if none is given, the hair is brown.
void readHair(Reading& reading, TextureRegistry& textures, const Arguments& arguments, Material& material);

}  // namespace eikonal::pbrt
