#pragma once
// From the text of a kernel to something that can be launched.

#include "device/cache.h"
#include "device/context.h"
#include "device/source.h"

#include <map>
#include <memory>

namespace eikonal {

/// How programs are built.
struct BuildSettings {
    Features features;
    Constants constants;
    bool contraction = true;     ///< a*b+c may become one operation
    bool warningsAreErrors = false;
    std::string more;            ///< options of OpenCL's compiler, besides those that are always set
    bool poison = false;         ///< new items hold a value that tests recognise
    std::string dumpFolder;      ///< not empty: write each program's text and options there
};

/// A built program with one kernel.
struct Program {
    Owned<cl_program, clReleaseProgram> handle;
    std::string kernel;
    std::vector<std::string> arguments;   ///< names of the kernel's arguments, in order
    bool fromCache = false;
    double seconds = 0;                   ///< to build or load
    double compileSeconds = 0;            ///< fromCache: what compiling it once took, the first launch with it
    std::string cacheKey;                 ///< what the cache knows it by; empty if it comes from there
};

/// Builds programs for one device, and keeps their binaries in a cache.
class Compiler {
public:
    /// cacheFolder empty: no cache.
    Compiler(const Context& context, KernelFolders folders, std::string cacheFolder);

    /// The program made of `text` (which includes files of the kernel folder) with kernel `kernel`.
    /// Throws a DeviceError with the build log, which names our files and lines.
    std::shared_ptr<Program> build(const std::string& text, const std::string& kernel, const BuildSettings& settings);
    /// Whether build() would find that program in the cache.
    bool isKept(const std::string& text, const std::string& kernel, const BuildSettings& settings) const;
    /// Keeps the program's binary for later starts. Best once its kernel has been launched, since an implementation may compile at the
    /// first launch only; and only while the device is idle: PoCL 3.1 aborts when a binary is asked for during a launch.
    void keep(const Program& program, double firstLaunchSeconds = 0) const;

    const KernelFolders& folders() const { return folders_; }
    const ProgramCache& cache() const { return cache_; }

private:
    /// That text with its files: put together once.
    const KernelSource& sourceOf(const std::string& text) const;
    std::string keyOf(const KernelSource& source, const std::string& options, const std::string& kernel) const;
    std::shared_ptr<Program> loadCached(const std::string& key, const std::string& kernel) const;

    const Context& context_;
    KernelFolders folders_;
    ProgramCache cache_;
    mutable std::map<std::string, KernelSource> sources_;
};

}  // namespace eikonal
