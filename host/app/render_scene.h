#pragma once
// One render of a call.

#include "app/options.h"
#include "render/open_device.h"

#include <map>
#include <memory>
#include <string>

namespace eikonal {

/// The files of images that a call has written, and which scene they are of.
using WrittenImages = std::map<std::string, std::string>;

/// Renders the scene `options.scene.path` into its files. device: shared with the renders before and after; null: one is opened. Returns
/// what renderCommand returns for a single scene, and throws an Error that says what is missing.
int renderScene(const Options& options, std::shared_ptr<OpenDevice>& device, WrittenImages& written);

}  // namespace eikonal
