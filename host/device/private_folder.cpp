#include "device/private_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

namespace fs = std::filesystem;

namespace eikonal {

constexpr std::string_view prefix = "eikonal-pocl-";

static int openFolder(const std::string& path) { return ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC); }

/// Removes the folders of processes that have ended.
static void sweep(const std::string& parent) {
    std::error_code error;
    for (fs::directory_iterator i(parent, error), end; !error && i != end; i.increment(error)) {
        if (!i->path().filename().string().starts_with(prefix)) continue;
        const int folder = openFolder(i->path().string());
        if (folder < 0) continue;
        struct stat status {};
        std::error_code ignored;
        if (::fstat(folder, &status) == 0 && status.st_uid == geteuid() && ::flock(folder, LOCK_EX | LOCK_NB) == 0) fs::remove_all(i->path(), ignored);
        ::close(folder);
    }
}

PrivateFolder::PrivateFolder(const std::string& parent) {
    sweep(parent);
    while (lock_ < 0) {
        path_ = (fs::path(parent) / (std::string(prefix) + "XXXXXX")).string();
        if (!::mkdtemp(path_.data())) { path_.clear(); return; }
        lock_ = openFolder(path_);
        if (lock_ < 0) {
            ::rmdir(path_.c_str());
            path_.clear();
            return;
        }

        /* Between mkdir and the lock, another process may have removed the folder as stale */
        struct stat status {};
        ::flock(lock_, LOCK_EX);
        if (::fstat(lock_, &status) == 0 && status.st_nlink > 0) return;
        ::close(lock_);
        lock_ = -1;
    }
}

PrivateFolder::~PrivateFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
    if (lock_ >= 0) ::close(lock_);
}

}  // namespace eikonal
