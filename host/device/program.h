#pragma once
// Builds kernels from source.

#include "device/cache.h"
#include "device/context.h"
#include "device/math_flags.h"
#include "device/source.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace eikonal {

/// Build settings of programs.
struct BuildSettings {
    Features features;
    Constants constants;
    bool contraction = true;     ///< allow a*b+c as one fused operation
    bool warningsAreErrors = false;
    std::string mathFlags = shippedMathFlags;
    std::vector<StageFlags> stageFlags;   ///< of stages that differ from `mathFlags`; the last one that fits counts
    std::string more;            ///< additional options for the OpenCL compiler
    bool poison = false;         ///< fill new items with a value that tests recognise
    std::string dumpFolder;      ///< if not empty, write the source and options of each program there
};

/// A built program with one kernel.
struct Program {
    Owned<cl_program, clReleaseProgram> handle;
    std::string kernel;
    std::vector<std::string> arguments;   ///< names of the kernel's arguments, in order
    bool fromCache = false;               ///< or built before in this process
    double seconds = 0;                   ///< time to build or load
    double compileSeconds = 0;            ///< if fromCache: the time of the original compilation, with the first launch
    std::string cacheKey;                 ///< key in the cache; empty if it was loaded from there
};

/// Builds programs for one device, each once, and keeps their binaries in a cache.
class Compiler {
public:
    /// An empty `cacheFolder`: no cache.
    Compiler(const Context& context, KernelFolders folders, std::string cacheFolder);

    /// Builds `text`, which includes files of the kernel folder, and creates `kernel`. Throws a DeviceError with the build log, whose
    /// messages name files and lines of the kernel folder.
    std::shared_ptr<Program> build(const std::string& text, const std::string& kernel, const BuildSettings& settings);
    /// Whether build() would find this program, in the cache or among those that it has built.
    bool isKept(const std::string& text, const std::string& kernel, const BuildSettings& settings) const;
    /// Writes the program's binary to the cache. Call it after the first launch of the kernel, since some implementations compile only
    /// then, and while the device is idle: PoCL 3.1 aborts if a binary is queried during a launch.
    void keep(const Program& program, double firstLaunchSeconds = 0) const;

    const KernelFolders& folders() const { return files_.folders(); }
    const ProgramCache& cache() const { return cache_; }

private:
    /// The source that `text` expands to, cached.
    const KernelSource& sourceOf(const std::string& text) const;
    std::string keyOf(const KernelSource& source, const std::string& options, const std::string& kernel) const;
    std::shared_ptr<Program> loadCached(const std::string& key, const std::string& kernel) const;

    const Context& context_;
    mutable KernelFiles files_;
    ProgramCache cache_;
    mutable std::map<std::string, KernelSource> sources_;
    std::map<std::string, std::shared_ptr<Program>> built_;  ///< by key
};

}  // namespace eikonal
