#include "app/commands.h"
#include "render/session.h"
#include "app/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace eikonal {

static void print(const std::string& text) { std::fputs(text.c_str(), stdout); }

static void describeCache(const std::string& folder) {
    size_t entries = 0, bytes = 0;
    std::error_code error;
    for (std::filesystem::directory_iterator i(folder, error), end; !error && i != end; i.increment(error)) {
        std::error_code gone;
        if (i->path().extension() != ".program") continue;
        const auto size = i->file_size(gone);
        if (gone) continue;
        ++entries;
        bytes += size;
    }
    print(fmt::format("{}\n{} compiled kernels, {}\n", folder, entries, readableBytes(static_cast<double>(bytes))));
}

/// The scenes that come with the program, in a folder next to the kernels.
static std::vector<std::string> ownScenes() {
    const std::filesystem::path folder = std::filesystem::path(findKernelFolders().kernels).parent_path() / "scenes";
    std::vector<std::string> scenes;
    std::error_code error;
    for (std::filesystem::directory_iterator i(folder, error), end; !error && i != end; i.increment(error))
        if (i->path().extension() == ".pbrt") scenes.push_back(i->path().string());
    if (scenes.empty()) throw UsageError(fmt::format("there are no scenes in {}; name some: eikonal cache --warm scene.pbrt", folder.string()));
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

/// Compiles the kernels that a scene requires; they are on disk when this returns.
static void warm(const Options& o, const std::string& scene, Diagnostics& diagnostics) {
    Options own = o;
    own.scene.path = scene;
    Session session(own, diagnostics);
    session.load();
    session.pack({});
    session.prepare();
    print(fmt::format("{}: {} kernels, {} of them compiled now, in {:.1f} s\n", scene, session.stages().all().size(), session.compiledStages(), session.times().compile));
}

int cacheCommand(const Options& o) {
    Diagnostics diagnostics(o.log);
    if (o.clearCache) {
        /* The preferred folder may have been refused because its disk is full: clear that one, too */
        const std::string refused = ProgramCache::chooseFolder().refused;
        if (const int count = ProgramCache(refused).clear()) print(fmt::format("removed {} compiled kernels from {}\n", count, refused));
    }
    const std::string folder = ProgramCache::defaultFolder();
    if (folder.empty()) throw Error(ExitCode::scene, "no folder for the cache is writable; set EIKONAL_CACHE_DIR to a writable one");
    if (o.clearCache) print(fmt::format("removed {} compiled kernels from {}\n", ProgramCache(folder).clear(), folder));
    if (o.warmCache)
        for (const std::string& scene : o.scenes.empty() ? ownScenes() : o.scenes) warm(o, scene, diagnostics);
    if (!o.clearCache && !o.warmCache) describeCache(folder);
    return static_cast<int>(ExitCode::success);
}

}  // namespace eikonal
