#pragma once
// Files that are written completely or not at all.

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace eikonal {

/// A file that is written piece by piece into a temporary file in the same folder, and takes its place in commit(). Follows a symbolic link
/// and replaces its target. Its functions throw Error (ExitCode::scene), "cannot write "path": reason", and leave the old file as it was.
class AtomicFile {
public:
    explicit AtomicFile(const std::string& path);
    /// Removes the temporary file unless commit() has been called.
    ~AtomicFile();
    void write(std::span<const unsigned char> content);
    /// Once it returns, the new content is on disk, and survives a crash of the machine.
    void commit();

private:
    class Temporary;
    std::string path_;
    std::unique_ptr<Temporary> file_;
};

/// Removes temporary files next to `path` that processes of this machine left when they were killed.
void removeAbandonedFiles(const std::string& path);

/// Replaces a file's content: writes a temporary file in its folder and renames it. Follows a symbolic link and replaces its target. Throws
/// Error (ExitCode::scene), "cannot write "path": reason", and leaves the old file as it was.
void writeFileAtomically(const std::string& path, std::span<const unsigned char> content);
void writeTextAtomically(const std::string& path, const std::string& text);

/// Throws the same Error now if it is foreseeable: no folder, no permission, not a regular file, or fewer than `bytes` bytes free.
void checkFileWritable(const std::string& path, std::uint64_t bytes);

/// A name of no file yet, beside `path`: "image-2.film" beside "image.film", or with the next number that is free.
std::string nameBeside(const std::string& path);

}  // namespace eikonal
