#include "kinds/texture_reading.h"

#include <algorithm>

namespace eikonal::pbrt {

void readOperands(const TextureReading& in, std::initializer_list<const char*> names, Texture& texture) {
    for (const char* name : names) texture.operands.push_back(in.textures.input(in.arguments, name));
}

int choose(const Arguments& arguments, const std::string& name, std::initializer_list<const char*> words) {
    const std::string word = arguments.text(name);
    const auto found = std::ranges::find(words, word);
    if (found != words.end()) return static_cast<int>(found - words.begin());
    std::string list;
    for (const char* w : words) list += std::string(list.empty() ? "\"" : ", \"") + w + '"';
    throw SceneError(arguments.whereOf(name), "\"string " + name + "\" is \"" + word + "\"; it can be " + list);
}

void readMapping(const TextureReading& in, Texture& texture) {
    constexpr texture_mapping mappings[] = {mapping_uv, mapping_spherical, mapping_cylindrical, mapping_planar};
    const Arguments& arguments = in.arguments;
    Mapping& mapping = texture.mapping;
    mapping.kind = mappings[choose(arguments, "mapping", {"uv", "spherical", "cylindrical", "planar"})];
    if (mapping.kind == mapping_uv) {
        mapping.uScale = arguments.number("uscale");
        mapping.vScale = arguments.number("vscale");
    }
    if (mapping.kind == mapping_uv || mapping.kind == mapping_planar) {
        mapping.uOffset = arguments.number("udelta");
        mapping.vOffset = arguments.number("vdelta");
    }
    mapping.planeU = arguments.vector("v1", {1, 0, 0});
    mapping.planeV = arguments.vector("v2", {0, 1, 0});
}

void readOctaves(const TextureReading& in, Texture& texture) {
    texture.octaves = in.arguments.integer("octaves");
    if (texture.octaves < 0 || texture.octaves > MOST_OCTAVES)
        throw SceneError(in.arguments.whereOf("octaves"),
                         "\"integer octaves\" is " + std::to_string(texture.octaves) + "; it can be 0 to " + std::to_string(MOST_OCTAVES));
    texture.roughness = in.arguments.number("roughness");
}

}  // namespace eikonal::pbrt
