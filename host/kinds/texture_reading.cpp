#include "kinds/texture_reading.h"

#include <algorithm>

namespace eikonal::pbrt {

void readOperands(const TextureReading& in, std::initializer_list<const char*> names, Texture& texture) {
    for (const char* name : names) texture.operands.push_back(in.textures.input(in.arguments, name));
}

size_t choose(const Arguments& arguments, const std::string& name) {
    const std::vector<std::string>& words = arguments.kind().rule(name)->choices;
    return static_cast<size_t>(std::ranges::find(words, arguments.text(name)) - words.begin());
}

void readMapping(const TextureReading& in, Texture& texture) {
    constexpr texture_mapping mappings[] = {mapping_uv, mapping_spherical, mapping_cylindrical, mapping_planar};
    const Arguments& arguments = in.arguments;
    Mapping& mapping = texture.mapping;
    mapping.kind = mappings[choose(arguments, "mapping")];
    if (mapping.kind == mapping_uv) {
        mapping.uScale = arguments.number("uscale");
        mapping.vScale = arguments.number("vscale");
    }
    if (mapping.kind == mapping_uv || mapping.kind == mapping_planar) {
        mapping.uOffset = arguments.number("udelta");
        mapping.vOffset = arguments.number("vdelta");
    }
    if (mapping.kind == mapping_planar) {
        mapping.planeU = arguments.vector("v1", {1, 0, 0});
        mapping.planeV = arguments.vector("v2", {0, 1, 0});
    }
}

void readOctaves(const TextureReading& in, Texture& texture) {
    texture.octaves = in.arguments.integer("octaves");
    if (texture.octaves < 0 || texture.octaves > MOST_OCTAVES)
        throw SceneError(in.arguments.whereOf("octaves"),
                         "\"integer octaves\" is " + std::to_string(texture.octaves) + "; it can be 0 to " + std::to_string(MOST_OCTAVES));
    texture.roughness = in.arguments.number("roughness");
}

}  // namespace eikonal::pbrt
