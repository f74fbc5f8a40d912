#include "test_device.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>

namespace fs = std::filesystem;

namespace eikonal {

const std::string& testCacheFolder() {
    static const std::string folder = [] {
        const fs::path path = fs::temp_directory_path() / ("eikonal-kernel-tests-" + std::to_string(getuid()));
        fs::create_directories(path);
        return path.string();
    }();
    return folder;
}

static DeviceInfo testDevice() {
    ::setenv("POCL_CACHE_DIR", (testCacheFolder() + "/pocl").c_str(), 0);   // kept from test to test
    preparePocl(testCacheFolder());
    if (const char* wanted = std::getenv("EIKONAL_TEST_DEVICE")) return chooseDevice(wanted);
    for (const DeviceInfo& d : listDevices())
        if (d.platformName.find("Portable Computing Language") != std::string::npos) return d;
    return chooseDevice("");
}

const Context& testContext() {
    static const Context context(testDevice());
    return context;
}

Compiler& testCompiler() {
    static Compiler compiler(testContext(), findKernelFolders(), testCacheFolder());
    return compiler;
}

BuildSettings shippedSettings(const Features& features, const SceneConstants& constants) {
    BuildSettings settings;
    settings.features = features;
    settings.constants = {{"LOCAL_SIZE", static_cast<int>(testLocalSize)},
                          {"ITEMS_PER_WORK_ITEM", static_cast<int>(testRun)},
                          {"WIDENS_GROUPS", testContext().device().widensGroups}};
    constants.forEach([&](const char* name, int number) { settings.constants[name] = number; });
    settings.warningsAreErrors = true;
    return settings;
}

bool hasKernelFile(const std::string& name) { return fs::exists(fs::path(findKernelFolders().kernels) / name); }

}  // namespace eikonal
