#include "kinds/light_kind.h"

#include "kind_features.h"
namespace eikonal {

std::span<const LightKind> lightKindList() {
    static const LightKind entries[] = {
#define ADD_ENTRY(name, FEATURE, PLACE) {#name, kind_##name##_light, KindFeature::FEATURE, LightPlace::PLACE, name##_light},
        LIGHTS(ADD_ENTRY)
#undef ADD_ENTRY
    };
    return entries;
}

}  // namespace eikonal
