#pragma once
// Reads lights and area lights.

#include "error.h"
#include "read/pbrt/kinds.h"
#include "read/pbrt/parameters.h"
#include "read/pbrt/reading.h"
#include "read/pbrt/state.h"
#include "read/pbrt/textures.h"

#include <string>

namespace eikonal::pbrt {

const KindTable& lightKinds();
const KindTable& areaLightKinds();

/// Adds a light to Scene::lights if it is rendered. Throws SceneError.
void addLight(Reading& reading, TextureRegistry& textures, const std::string& kind, const GraphicsState& state, ParameterList parameters,
              const SourceLocation& where);

/// Adds an area light to Scene::areaLights and returns its index. Throws SceneError.
int addAreaLight(Reading& reading, TextureRegistry& textures, const std::string& kind, const GraphicsState& state, ParameterList parameters,
                 const SourceLocation& where);

}  // namespace eikonal::pbrt
