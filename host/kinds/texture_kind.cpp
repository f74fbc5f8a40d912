#include "kinds/texture_kind.h"

namespace eikonal {

std::span<const TextureKind> textureKindList() {
    static const TextureKind entries[] = {
#define ADD_ENTRY(name, FEATURE, OPERANDS) {#name, kind_##name##_texture, Feature::FEATURE, OPERANDS, name##_texture},
        TEXTURES(ADD_ENTRY)
#undef ADD_ENTRY
    };
    return entries;
}

}  // namespace eikonal
