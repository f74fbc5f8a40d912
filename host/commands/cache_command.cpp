#include "commands/commands.h"
#include "commands/session.h"
#include "commands/statistics.h"

#include <fmt/format.h>

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

/// Compiles what a scene requires; the kernels are on disk when this returns.
static void warm(const Options& o, const std::string& scene, Diagnostics& diagnostics) {
    Options own = o;
    own.scene.path = scene;
    Session session(own, diagnostics);
    session.load();
    session.pack(false);
    session.prepare();
    print(fmt::format("{}: {} kernels, of which {} were compiled in {:.1f} s\n", scene, session.stages().all().size(), session.compiledStages(), session.times().compile));
}

int cacheCommand(const Options& o) {
    Diagnostics diagnostics(o.log);
    prepareOpenCl(o.device);
    const std::string folder = ProgramCache::defaultFolder();
    if (folder.empty()) throw Error(ExitCode::scene, "no folder for the cache can be written; set EIKONAL_CACHE_DIR to one");
    if (o.clearCache) print(fmt::format("removed {} compiled kernels from {}\n", ProgramCache(folder).clear(), folder));
    else if (!o.warmCache) describeCache(folder);
    for (const std::string& scene : o.scenes) warm(o, scene, diagnostics);
    return static_cast<int>(ExitCode::success);
}

}  // namespace eikonal
