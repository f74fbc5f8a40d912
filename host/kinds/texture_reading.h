#pragma once
// Shared code for reading textures from a pbrt scene.

#include "kinds/texture_kind.h"
#include "read/pbrt/arguments.h"
#include "read/pbrt/textures.h"
#include "scene/textures.h"

#include <initializer_list>
#include <string>

namespace eikonal::pbrt {

/// The input of a texture's `read`.
struct TextureReading {
    Reading& reading;
    TextureRegistry& textures;   ///< finds other textures by name
    const Arguments& arguments;
};

/* Parts of rows (read/pbrt/kinds.h) that several kinds share */
constexpr const char* mappingParameters =
    "string mapping = uv in {uv, spherical, cylindrical, planar};"
    "float uscale = 1; float vscale = 1; float udelta = 0; float vdelta = 0; vector3 v1; vector3 v2";
constexpr const char* octaveParameters = "integer octaves = 8; float roughness = 0.5";

/// Reads operands from the parameters with these names, in this order.
void readOperands(const TextureReading& in, std::initializer_list<const char*> names, Texture& texture);

/// Reads the mapping to texture coordinates. Throws SceneError for an unknown one.
void readMapping(const TextureReading& in, Texture& texture);

/// Reads "octaves" and "roughness". Throws SceneError if "octaves" is not in [0, MOST_OCTAVES].
void readOctaves(const TextureReading& in, Texture& texture);

/// The index of a parameter's value among the choices of its rule.
size_t choose(const Arguments& arguments, const std::string& name);

}  // namespace eikonal::pbrt
