#include "render/device_scene.h"

namespace eikonal {

DeviceScene::DeviceScene(const Context& context, const PackedScene& scene) : stopFlag_(context) {
    const auto upload = [&](const auto& table, const char* name) {
        Buffer& buffer = buffers_[name];
        buffer = Buffer::sharing(context, table, std::string("table ") + name);
        bindings_.set(name, buffer);
        bytes_ += buffer.size();
    };
#define UPLOAD_TABLE(type, name) upload(scene.tables.name, #name);
    SCENE_TABLES(UPLOAD_TABLE)
#undef UPLOAD_TABLE
    bindings_.set("stop", stopFlag_.buffer());
    /* The only table that kernels write */
    replace(context, "implicit_doubts", std::vector<uint>(implicit_doubt_count, 0));
}

ImplicitDoubts DeviceScene::implicitDoubts(const Context& context) const {
    ImplicitDoubts counts;
    buffers_.at("implicit_doubts").read(context, counts.data(), sizeof counts);
    return counts;
}

void DeviceScene::setFrame(const Context& context, const settings& frame) { buffers_.at("frame").write(context, &frame, sizeof frame); }

}  // namespace eikonal
