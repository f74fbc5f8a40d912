#pragma once
// A cache of program binaries of our own: with it, a second start does not compile. One file for each program.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// What is kept of a program.
struct CachedProgram {
    std::vector<unsigned char> binary;
    std::vector<std::string> arguments;   ///< names of its kernel's arguments: a binary does not tell them
    double seconds = 0;                   ///< that it took to compile
};

/// Where compiled kernels are kept.
struct CacheFolder {
    std::string path;              ///< empty: nowhere
    std::string refused, reason;   ///< where they ought to be, if that is elsewhere, and what is wrong with it: "cannot be written"
};

/// A folder of files, each named by a hash of its key and holding the whole key. A file that is damaged or was written for
/// something else counts as absent; a folder that cannot be written is not used. Nothing here ever fails.
class ProgramCache {
public:
    /// An empty folder: no cache.
    explicit ProgramCache(std::string folder) : folder_(std::move(folder)) {}

    std::optional<CachedProgram> load(const std::string& key) const;
    void store(const std::string& key, const CachedProgram& program) const;
    /// Removes every entry, and what was left of entries that were never finished; returns how many entries.
    int clear() const;
    const std::string& folder() const { return folder_; }

    /// $EIKONAL_CACHE_DIR, else $XDG_CACHE_HOME/eikonal, else ~/.cache/eikonal. If that cannot be written, or its disk is full, a folder of
    /// temporary files that belongs to this user and that nobody else may write; nowhere if it is not so.
    static CacheFolder chooseFolder();
    static std::string defaultFolder() { return chooseFolder().path; }

private:
    std::string fileFor(const std::string& key) const;
    std::string folder_;
};

/// Settings for PoCL, before the first call of OpenCL, and the first time while there is one thread only; what the environment sets already stays. One compiled variant of each kernel. A folder of
/// this process and its workers alone, which goes with it: PoCL runs what it finds in its folder unseen, and aborts the program if that is
/// damaged. It unpacks our programs into it, whose checksums were right. `cacheFolder` is where that folder is put if need be.
void preparePocl(const std::string& cacheFolder);

}  // namespace eikonal
