#pragma once
// A temporary folder that does not outlive its process.

#include <string>

namespace eikonal {

/// A new folder that only this user can open, removed by the destructor. Folders of killed processes are removed by the next process that
/// makes one in the same place: a living process holds a lock on its own.
class PrivateFolder {
public:
    /// Makes the folder inside `parent`. Does not throw; path() is empty if it could not be made.
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
