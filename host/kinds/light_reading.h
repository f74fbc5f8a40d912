#pragma once
// What kinds of lights read of a pbrt scene.

#include "kinds/light_kind.h"
#include "read/pbrt/arguments.h"
#include "read/pbrt/textures.h"
#include "scene/lights.h"

namespace eikonal::pbrt {

/// What there is to read a light from.
struct LightReading {
    Reading& reading;
    TextureRegistry& textures;
    const Arguments& arguments;
};

/// The default of light: 1 in the color space that is in effect.
Spectrum whiteOf(const Arguments& arguments);

/// The power in watts, or 0 if none is given.
double powerOf(const Arguments& arguments);

/// Reads "from" and "to". Throws SceneError where both are the same point.
void readDirection(const Arguments& arguments, Light& light);

/// Reads the image of a light that needs one. False: the file is missing, which is noted. Throws SceneError where none is named.
bool readImage(const LightReading& in, WrapMode wrap, Light& light);

}  // namespace eikonal::pbrt
