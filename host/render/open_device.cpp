#include "render/open_device.h"

#include <fmt/format.h>

namespace eikonal {

OpenDevice::OpenDevice(const DeviceOptions& all, bool profiling)
    : options(all),
      context(chooseDevice(options.device), profiling),
      compiler(context, findKernelFolders(), cacheFolderFor(options)),
      shape(shapeFor(context.device(), options)) {}

OpenDevices openDevices(const DeviceOptions& options, bool profiling) {
    OpenDevices devices;
    for (const std::string& name : chooseDevices(listDevices(), options.device)) {
        DeviceOptions own = options;
        own.device = name;
        devices.push_back(std::make_shared<OpenDevice>(own, profiling));
    }
    return devices;
}

std::string cacheFolderFor(const DeviceOptions& options) { return options.cache ? ProgramCache::defaultFolder() : std::string(); }

StageShape shapeFor(const DeviceInfo& device, const DeviceOptions& options) {
    StageShape shape = StageShape::forDevice(device);
    if (options.localSize && *options.localSize > device.largestGroup)
        throw UsageError(fmt::format("--local-size: \"{}\" has work-groups of at most {} items, not {}", device.name, device.largestGroup,
                                     *options.localSize));
    if (options.localSize) shape.localSize = *options.localSize;
    if (options.itemsPerWorkItem) shape.itemsPerWorkItem = *options.itemsPerWorkItem;
    if (options.wavePaths) shape.wavePaths = *options.wavePaths;
    return shape;
}

BuildSettings buildSettingsFor(const DeviceOptions& options) {
    BuildSettings settings;
    settings.contraction = options.contraction;
    settings.more = options.buildOptions;
    for (const StageFlags& s : options.mathFlags) {
        if (s.stage.empty()) settings.mathFlags = s.flags;
        else settings.stageFlags.push_back(s);
    }
    settings.dumpFolder = options.dumpFolder;
    return settings;
}

}  // namespace eikonal
