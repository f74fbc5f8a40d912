#include "kinds/medium_kind.h"

#include "kind_features.h"
#include "scene/media.h"

namespace eikonal {

std::span<const MediumKind> mediumKindList() {
    static const MediumKind entries[] = {
#define ADD_ENTRY(name, FEATURE, VARIATION) {#name, kind_##name##_medium, KindFeature::FEATURE, MediumVariation::VARIATION, name##_medium},
        MEDIA_KINDS(ADD_ENTRY)
#undef ADD_ENTRY
    };
    return entries;
}

MediumEmission emissionOf(const Medium& m) { return m.kind->traits.emission ? m.kind->traits.emission(m) : MediumEmission::none; }

}  // namespace eikonal
