#pragma once
// Shared code for reading lights from a pbrt scene.

#include "kinds/light_kind.h"
#include "read/pbrt/arguments.h"
#include "read/pbrt/textures.h"
#include "scene/lights.h"

namespace eikonal::pbrt {

/// The input of a light's `read`.
struct LightReading {
    Reading& reading;
    TextureRegistry& textures;
    const Arguments& arguments;
};

/// The default colour of a light: white of the current colour space.
Spectrum whiteOf(const Arguments& arguments);

/// The power in watts, or 0 if none is given.
double powerOf(const Arguments& arguments);

/// Reads "from" and "to". Throws SceneError if they are the same point.
void readDirection(const Arguments& arguments, Light& light);

/// Reads the image of a light that needs one. Returns false if the file is missing (already reported); throws SceneError if none is named.
bool readImage(const LightReading& in, image_wrap wrap, Light& light);

}  // namespace eikonal::pbrt
