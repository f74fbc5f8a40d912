#include "kinds/camera_kind.h"

namespace eikonal {

std::span<const CameraKind> cameraKindList() {
    static const CameraKind entries[] = {
#define ADD_ENTRY(name, FEATURE, CODE) {#name, camera_##name, Feature::FEATURE, name##_camera},
        CAMERAS(ADD_ENTRY)
#undef ADD_ENTRY
    };
    return entries;
}

}  // namespace eikonal
