#include "render/device_scene.h"

namespace eikonal {

DeviceScene::DeviceScene(const Context& context, const PackedScene& scene) : maxDepth_(scene.frame().max_depth) {
    const auto upload = [&](const auto& table, const char* name) {
        using Element = typename std::decay_t<decltype(table)>::value_type;
        buffers_.push_back(Buffer::of<Element>(context, table, std::string("table ") + name));
        bindings_.set(name, buffers_.back());
        bytes_ += buffers_.back().size();
    };
#define UPLOAD_TABLE(type, name) upload(scene.tables.name, #name);
    SCENE_TABLES(UPLOAD_TABLE)
#undef UPLOAD_TABLE
}

}  // namespace eikonal
