#include "device/kind_files.h"

#include "eikonal/cameras.h"
#include "eikonal/lights.h"
#include "eikonal/media.h"
#include "eikonal/shapes.h"
#include "eikonal/textures.h"

#include <fmt/format.h>

namespace eikonal {

std::optional<std::string> kindFiles(const std::string& name) {
    std::string includes, features;
    const auto add = [&](const char* family, const char* kind, const char* feature) {
        if (name != fmt::format("{}/kinds.clh", family)) return;
        includes += fmt::format("#include \"{}/{}.clh\"\n", family, kind);
        features += fmt::format(" HAS_{}", feature);
    };
#define ADD_LIGHT(kind, FEATURE, PLACE) add("light", #kind, #FEATURE);
    LIGHTS(ADD_LIGHT)
#undef ADD_LIGHT
#define ADD_MEDIUM(kind, FEATURE, VARIATION) add("medium", #kind, #FEATURE);
    MEDIA_KINDS(ADD_MEDIUM)
#undef ADD_MEDIUM
#define ADD_SHAPE(kind, FEATURE, SPACE) add("shape", #kind, #FEATURE);
    SHAPES(ADD_SHAPE)
#undef ADD_SHAPE
#define ADD_CAMERA(kind, FEATURE, CODE, RAYS) add("camera", #kind, #FEATURE);
    CAMERAS(ADD_CAMERA)
#undef ADD_CAMERA
#define ADD_TEXTURE(kind, FEATURE, OPERANDS) add("texture", #kind, #FEATURE);
    TEXTURES(ADD_TEXTURE)
#undef ADD_TEXTURE
    if (includes.empty()) return std::nullopt;
    return fmt::format("{}/* features of these kinds:{} */\n", includes, features);
}

}  // namespace eikonal
