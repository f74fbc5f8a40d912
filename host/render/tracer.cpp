#include "render/tracer.h"

namespace eikonal {

void bindTile(Bindings& bindings, const Tile& tile, int endX, int endY) {
    bindings.set("tile_x", static_cast<cl_uint>(tile.x));
    bindings.set("tile_y", static_cast<cl_uint>(tile.y));
    bindings.set("tile_log2_width", static_cast<cl_uint>(tile.log2Width));
    bindings.set("tile_log2_height", static_cast<cl_uint>(tile.log2Height));
    bindings.set("end_x", static_cast<cl_uint>(endX));
    bindings.set("end_y", static_cast<cl_uint>(endY));
    bindings.set("first_sample", tile.firstSample);
    bindings.set("samples", tile.samples);
    bindings.set("tile_pixels", tile.pixels());
}

unsigned mostHops(const DeviceScene& scene) { return scene.maxDepth() + 1 + (scene.hasWalks() ? 16384 : 1024); }

}  // namespace eikonal
