#include "film/reopened_file.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <mutex>
#include <utility>

namespace eikonal {
namespace {

std::mutex mutex;                          // guards the files' descriptors and the list
std::list<const ReopenedFile*> openFiles;  // the last read first

std::size_t mostOpen() {
    struct rlimit limit {};
    if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return 8;
    return std::max<std::size_t>(limit.rlim_cur / 2, 8);
}

}  // namespace

ReopenedFile::ReopenedFile(std::string path) : path_(std::move(path)) {
    const std::lock_guard lock(mutex);
    isOpen_ = open() && ::fstat(file_, &status_) == 0;
}

ReopenedFile::~ReopenedFile() {
    const std::lock_guard lock(mutex);
    close();
}

bool ReopenedFile::open() const {
    while (openFiles.size() >= mostOpen()) openFiles.back()->close();
    file_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file_ < 0) return false;
    openFiles.push_front(this);
    place_ = openFiles.begin();
    return true;
}

void ReopenedFile::close() const {
    if (file_ < 0) return;
    ::close(std::exchange(file_, -1));
    openFiles.erase(place_);
}

ssize_t ReopenedFile::read(void* content, std::size_t bytes, off_t place) const {
    const std::lock_guard lock(mutex);
    if (file_ >= 0) openFiles.splice(openFiles.begin(), openFiles, place_);
    else {
        struct stat now {};
        if (!open() || ::fstat(file_, &now) != 0) return -1;
        if (now.st_dev != status_.st_dev || now.st_ino != status_.st_ino) {
            close();
            errno = ESTALE;
            return -1;
        }
    }
    return ::pread(file_, content, bytes, place);
}

}  // namespace eikonal
