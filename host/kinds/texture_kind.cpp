#include "kinds/texture_kind.h"

#include "kind_features.h"
namespace eikonal {

std::span<const TextureKind> textureKindList() {
    static const TextureKind entries[] = {
#define ADD_ENTRY(name, FEATURE, OPERANDS) {#name, kind_##name##_texture, KindFeature::FEATURE, OPERANDS, name##_texture},
        TEXTURES(ADD_ENTRY)
#undef ADD_ENTRY
    };
    return entries;
}

}  // namespace eikonal
