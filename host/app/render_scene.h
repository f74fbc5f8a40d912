#pragma once
// One render of a call.

#include "app/options.h"
#include "render/open_device.h"

#include <map>
#include <string>

namespace eikonal {

/// The files of images that a call has written, and which scene they are of.
using WrittenImages = std::map<std::string, std::string>;

/// Renders the scene `options.scene.path` into its files. devices: shared with the renders before and after; none: they are opened. Returns
/// what renderCommand returns for a single scene, and throws an Error that says what is missing.
int renderScene(const Options& options, OpenDevices& devices, WrittenImages& written);

}  // namespace eikonal
