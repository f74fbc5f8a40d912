#include "kinds/camera_kind.h"

#include "kind_features.h"
namespace eikonal {

std::span<const CameraKind> cameraKindList() {
    static const CameraKind entries[] = {
#define ADD_ENTRY(name, FEATURE, CODE, RAYS) {#name, camera_##name, KindFeature::FEATURE, CameraRays::RAYS, name##_camera},
        CAMERAS(ADD_ENTRY)
#undef ADD_ENTRY
    };
    return entries;
}

}  // namespace eikonal
