#include "render/tracer.h"

namespace eikonal {

unsigned mostHops(const DeviceScene& scene) { return scene.maxDepth() + 1 + (scene.hasWalks() ? 16384 : 1024); }

}  // namespace eikonal
