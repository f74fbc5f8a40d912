#include "image/atomic_file.h"

#include "error.h"
#include "shell_word.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace eikonal {
namespace {

/// Temporary files are called ".eikonal-MACHINE-PROCESS-NUMBER.part".
std::string temporaryPrefix() {
    char name[256] = {};
    ::gethostname(name, sizeof name - 1);
    return fmt::format(".eikonal-{}-", name);
}
constexpr const char* temporarySuffix = ".part";

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
    throw Error(ExitCode::scene, fmt::format("cannot write \"{}\": {}", path, reason));
}

/// The file that is written in the end: `path` with symbolic links followed.
fs::path target(const std::string& path) {
    std::error_code error;
    const fs::path resolved = fs::weakly_canonical(path, error);
    return error ? fs::path(path) : resolved;
}

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

void checkPlace(const std::string& path, const fs::path& place);

}  // namespace

/// A temporary file next to its final place, removed unless it was renamed.
class AtomicFile::Temporary {
public:
    Temporary(const std::string& path, const fs::path& folder) : path_(path), folder_(folder) {
        static std::atomic<int> count = 0;
        name_ = folder / fmt::format("{}{}-{}{}", temporaryPrefix(), ::getpid(), count++, temporarySuffix);
        ::unlink(name_.c_str());
        file_ = ::open(name_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (file_ < 0) fail(path_, fmt::format("cannot create a file in \"{}\": {}", folder.string(), std::strerror(errno)));
    }
    ~Temporary() {
        if (file_ >= 0) ::close(file_);
        if (!renamed_) ::unlink(name_.c_str());
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    void write(std::span<const unsigned char> content) {
        while (!content.empty()) {
            const ssize_t written = ::write(file_, content.data(), content.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) fail(path_, std::strerror(errno));
            content = content.subspan(static_cast<std::size_t>(written));
        }
    }

    void moveTo(const fs::path& place) {
        const bool flushed = ::fsync(file_) == 0;
        const int error = errno;
        const bool closed = ::close(file_) == 0;
        file_ = -1;
        if (!flushed || !closed) fail(path_, std::strerror(flushed ? errno : error));
        if (::rename(name_.c_str(), place.c_str()) != 0) fail(path_, std::strerror(errno));
        renamed_ = true;
        syncFolder();
    }

private:
    /// Makes the new name as durable as the content. Some file systems cannot, which is no error.
    void syncFolder() const {
        const int folder = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (folder < 0) return;
        ::fsync(folder);
        ::close(folder);
    }

    std::string path_;
    fs::path folder_, name_;
    int file_ = -1;
    bool renamed_ = false;
};

namespace {

void checkPlace(const std::string& path, const fs::path& place) {
    std::error_code error;
    const fs::path folder = folderOf(place);
    const fs::file_status status = fs::status(place, error);
    if (fs::is_directory(status)) fail(path, "it is a folder");
    if (!fs::is_directory(folder, error))
        fail(path, fmt::format("there is no folder \"{}\"; make it: mkdir -p {}", folder.string(), shellWord(folder.string())));
    if (fs::exists(status) && !fs::is_regular_file(status)) fail(path, "it is not a regular file");
    if (fs::exists(status) && ::access(place.c_str(), W_OK) != 0) fail(path, std::strerror(errno));
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path) {
    const fs::path place = target(path);
    checkPlace(path, place);
    file_ = std::make_unique<Temporary>(path, folderOf(place));
}

AtomicFile::~AtomicFile() = default;

void AtomicFile::write(std::span<const unsigned char> content) { file_->write(content); }
void AtomicFile::commit() { file_->moveTo(target(path_)); }

void writeFileAtomically(const std::string& path, std::span<const unsigned char> content) {
    AtomicFile file(path);
    file.write(content);
    file.commit();
}

void removeAbandonedFiles(const std::string& path) {
    const std::string prefix = temporaryPrefix();
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folderOf(target(path)), error)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(prefix) || !name.ends_with(temporarySuffix)) continue;
        const int process = std::atoi(name.c_str() + prefix.size());
        if (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) fs::remove(entry.path(), error);
    }
}

void writeTextAtomically(const std::string& path, const std::string& text) {
    writeFileAtomically(path, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

void checkFileWritable(const std::string& path, std::uint64_t bytes) {
    const fs::path place = target(path), folder = folderOf(place);
    AtomicFile{path};
    std::error_code error;
    const fs::space_info space = fs::space(folder, error);
    constexpr double megabyte = 1e6;
    if (!error && space.available < bytes)
        fail(path, fmt::format("it needs about {:.1f} MB in \"{}\", but only {:.1f} MB are free", static_cast<double>(bytes) / megabyte,
                               folder.string(), static_cast<double>(space.available) / megabyte));
}

std::string nameBeside(const std::string& path) {
    const fs::path place = path;
    for (int number = 2;; ++number) {
        fs::path name = place;
        name.replace_filename(fmt::format("{}-{}{}", place.stem().string(), number, place.extension().string()));
        std::error_code error;
        if (!fs::exists(name, error)) return name.string();
    }
}

}  // namespace eikonal
