#pragma once
// Files that are read, however many there are.

#include <sys/stat.h>
#include <sys/types.h>

#include <cstddef>
#include <list>
#include <string>

namespace eikonal {

/// A file that is open for reading, as far as its readers notice. When more are open than half of what the process may have, the one that
/// was read longest ago is closed, until it is read again. Any thread may use any of them.
class ReopenedFile {
public:
    /// Opens it; isOpen() is false and errno says why if that fails.
    explicit ReopenedFile(std::string path);
    ~ReopenedFile();
    ReopenedFile(const ReopenedFile&) = delete;
    ReopenedFile& operator=(const ReopenedFile&) = delete;

    bool isOpen() const { return isOpen_; }
    const struct stat& status() const { return status_; }
    /// As pread(2). ESTALE: another file has taken its place meanwhile.
    ssize_t read(void* content, std::size_t bytes, off_t place) const;

private:
    bool open() const;
    void close() const;

    const std::string path_;
    struct stat status_ {};
    bool isOpen_ = false;
    mutable int file_ = -1;                                   ///< -1: closed
    mutable std::list<const ReopenedFile*>::iterator place_;  ///< among the open files, if it is open
};

}  // namespace eikonal
