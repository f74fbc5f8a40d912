#include "render/device_scene.h"

#include <algorithm>

namespace eikonal {

RaySplitting RaySplitting::of(const PackedScene& scene) {
    if (!scene.features.has(Feature::TREE)) return {};
    const settings& frame = scene.frame();
    const unsigned raysPerHit = std::max(2u, frame.rough_splits == NONE ? 0 : 1u << std::min(frame.rough_splits, frame.tree_splits));
    return {frame.tree_splits, raysPerHit, std::max(raysPerHit, frame.tree_lights)};
}

DeviceScene::DeviceScene(const Context& context, const PackedScene& scene) : splitting_(RaySplitting::of(scene)) {
    const auto upload = [&](const auto& table, const char* name) {
        Buffer& buffer = buffers_[name];
        buffer = Buffer::sharing(context, table, std::string("table ") + name);
        bindings_.set(name, buffer);
        bytes_ += buffer.size();
    };
#define UPLOAD_TABLE(type, name) upload(scene.tables.name, #name);
    SCENE_TABLES(UPLOAD_TABLE)
#undef UPLOAD_TABLE
}

void DeviceScene::setFrame(const Context& context, const settings& frame) { buffers_.at("frame").write(context, &frame, sizeof frame); }

}  // namespace eikonal
