#pragma once
// An on-disk cache of program binaries, so that a second start compiles nothing. One file per program.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// A cached program.
struct CachedProgram {
    std::vector<unsigned char> binary;
    std::vector<std::string> arguments;   ///< names of the kernel's arguments, which a binary does not report
    double seconds = 0;                   ///< compile time
};

/// The folder that holds compiled kernels.
struct CacheFolder {
    std::string path;              ///< empty: no cache
    std::string refused, reason;   ///< the preferred folder, if another is used, and why: "cannot be written"
};

/// A folder of files, each named by a hash of its key and holding the whole key. A damaged file, or one with another key, counts as absent;
/// a folder that is not writable is not used. No function here throws.
class ProgramCache {
public:
    /// An empty `folder`: no cache.
    explicit ProgramCache(std::string folder) : folder_(std::move(folder)) {}

    std::optional<CachedProgram> load(const std::string& key) const;
    void store(const std::string& key, const CachedProgram& program) const;
    /// Removes all entries and unfinished temporary files; returns the number of entries.
    int clear() const;
    const std::string& folder() const { return folder_; }

    /// $EIKONAL_CACHE_DIR, else $XDG_CACHE_HOME/eikonal, else ~/.cache/eikonal. If that is not writable or its disk is full, a folder among
    /// the temporary files that only this user may write; if there is none, no folder.
    static CacheFolder chooseFolder();
    static std::string defaultFolder() { return chooseFolder().path; }

private:
    std::string fileFor(const std::string& key) const;
    std::string folder_;
};

/// Sets environment variables for PoCL. Call it before the first OpenCL call and, the first time, while there is a single thread; variables
/// that are already set stay. It asks for one compiled variant of each kernel, and for a cache folder that is private to this process and
/// its workers and is removed at exit: PoCL loads files of its cache unchecked and aborts if one is damaged, so it only gets binaries that
/// this process has unpacked after checking them. `cacheFolder`: where the private folder goes if memory and temporary folder have no room.
void preparePocl(const std::string& cacheFolder);

}  // namespace eikonal
