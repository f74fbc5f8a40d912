#pragma once
// Shared code for reading lights from a pbrt scene.

#include "kinds/light_kind.h"
#include "read/pbrt/arguments.h"
#include "read/pbrt/textures.h"
#include "scene/lights.h"

#include <optional>

namespace eikonal::pbrt {

/// The input of a light's `read`.
struct LightReading {
    Reading& reading;
    TextureRegistry& textures;
    const Arguments& arguments;
};

/// The default colour of a light: white of the current colour space.
Spectrum whiteOf(const Arguments& arguments);

/// What a parameter like "power" (watts) or "illuminance" (lux) says how strong a light is in all; nothing if it is not given, or not above
/// 0, which has no effect, as in pbrt-v4. Warns of that, unless it is the default of -1.
std::optional<double> strengthOf(Reading& reading, const Arguments& arguments, const char* name);

/// Reads "from" and "to". Throws SceneError if they are the same point.
void readDirection(const Arguments& arguments, Light& light);

/// Reads the image of a light that needs one. Returns false if the file is missing (already reported); throws SceneError if none is named.
bool readImage(const LightReading& in, image_wrap wrap, Light& light);

}  // namespace eikonal::pbrt
