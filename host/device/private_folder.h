#pragma once
// A place for files that must not outlive the process.

#include <string>

namespace eikonal {

/// A new folder that only this user can open, and that goes with its object. What processes left that were killed before theirs went, the next
/// one that makes a folder in the same place removes: a living process holds a lock on its own.
class PrivateFolder {
public:
    /// In the folder `parent`. Throws nothing: path() is empty if none can be made there.
    explicit PrivateFolder(const std::string& parent);
    ~PrivateFolder();
    PrivateFolder(const PrivateFolder&) = delete;
    PrivateFolder& operator=(const PrivateFolder&) = delete;

    const std::string& path() const { return path_; }

private:
    std::string path_;
    int lock_ = -1;   ///< the folder, opened and locked
};

}  // namespace eikonal
