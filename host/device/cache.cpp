#include "device/cache.h"

#include "device/private_folder.h"
#include "device/source.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

namespace fs = std::filesystem;

namespace eikonal {

// File format: a magic line; key, argument names, seconds and binary, each preceded by its length; a checksum of everything before.
constexpr std::string_view magic = "eikonal program 2\n";

static void append(std::string& out, std::string_view bytes) {
    const std::uint64_t size = bytes.size();
    out.append(reinterpret_cast<const char*>(&size), sizeof size);
    out.append(bytes);
}

static std::optional<std::string_view> take(std::string_view& in) {
    std::uint64_t size = 0;
    if (in.size() < sizeof size) return std::nullopt;
    std::memcpy(&size, in.data(), sizeof size);
    in.remove_prefix(sizeof size);
    if (in.size() < size) return std::nullopt;
    const std::string_view bytes = in.substr(0, size);
    in.remove_prefix(size);
    return bytes;
}

static std::uint32_t checksum(std::string_view bytes) {
    return static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

static bool writable(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    return !error && access(folder.c_str(), W_OK | X_OK) == 0;
}

/// Whether only this user can have written to the folder; binaries in it are run. In a shared place its name can be guessed, so another
/// user may have created it.
static bool privatelyWritable(const fs::path& folder) {
    ::mkdir(folder.c_str(), S_IRWXU);
    struct stat status {};
    if (::lstat(folder.c_str(), &status) != 0) return false;
    return S_ISDIR(status.st_mode) && status.st_uid == geteuid() && (status.st_mode & (S_IWGRP | S_IWOTH)) == 0 && writable(folder);
}

/// The problem with a cache folder; empty if there is none.
static std::string fault(const fs::path& folder) {
    constexpr std::uintmax_t enough = 16u << 20;   // the kernels of a few scenes
    if (!writable(folder)) return "cannot be written";
    std::error_code error;
    const fs::space_info space = fs::space(folder, error);
    if (error || space.available >= enough) return {};
    return fmt::format("is on a disk with {:.1f} MiB free; at least {} MiB are needed", static_cast<double>(space.available) / (1 << 20),
                       enough >> 20);
}

CacheFolder ProgramCache::chooseFolder() {
    CacheFolder chosen;
    fs::path folder;
    if (const char* set = std::getenv("EIKONAL_CACHE_DIR")) folder = set;
    else if (const char* xdg = std::getenv("XDG_CACHE_HOME")) folder = fs::path(xdg) / "eikonal";
    else if (const char* home = std::getenv("HOME")) folder = fs::path(home) / ".cache" / "eikonal";
    if (!folder.empty()) {
        chosen.reason = fault(folder);
        if (chosen.reason.empty()) return {folder.string(), {}, {}};
        chosen.refused = folder.string();
    }
    std::error_code error;
    folder = fs::temp_directory_path(error) / fmt::format("eikonal-{}", geteuid());
    if (!error && privatelyWritable(folder) && fault(folder).empty()) chosen.path = folder.string();
    return chosen;
}

std::string ProgramCache::fileFor(const std::string& key) const {
    return (fs::path(folder_) / fmt::format("{:016x}.program", hashBytes(key))).string();
}

std::optional<CachedProgram> ProgramCache::load(const std::string& key) const {
    if (folder_.empty()) return std::nullopt;
    std::ifstream file(fileFor(key), std::ios::binary);
    if (!file) return std::nullopt;
    std::stringstream content;
    content << file.rdbuf();
    const std::string bytes = content.str();
    std::uint32_t sum = 0;
    if (bytes.size() < magic.size() + sizeof sum || bytes.compare(0, magic.size(), magic) != 0) return std::nullopt;
    std::memcpy(&sum, bytes.data() + bytes.size() - sizeof sum, sizeof sum);
    std::string_view rest(bytes.data(), bytes.size() - sizeof sum);
    if (checksum(rest) != sum) return std::nullopt;
    rest.remove_prefix(magic.size());
    const auto storedKey = take(rest), arguments = take(rest), seconds = take(rest), binary = take(rest);
    CachedProgram program;
    if (!storedKey || !arguments || !seconds || seconds->size() != sizeof program.seconds || !binary || *storedKey != key)
        return std::nullopt;

    std::memcpy(&program.seconds, seconds->data(), sizeof program.seconds);
    program.binary.assign(binary->begin(), binary->end());
    std::istringstream names{std::string(*arguments)};
    for (std::string name; std::getline(names, name);) program.arguments.push_back(name);
    return program;
}

void ProgramCache::store(const std::string& key, const CachedProgram& program) const {
    if (folder_.empty()) return;
    std::string names;
    for (const std::string& name : program.arguments) names += name + "\n";
    std::string bytes(magic);
    append(bytes, key);
    append(bytes, names);
    append(bytes, {reinterpret_cast<const char*>(&program.seconds), sizeof program.seconds});
    append(bytes, {reinterpret_cast<const char*>(program.binary.data()), program.binary.size()});
    const std::uint32_t sum = checksum(bytes);
    bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);

    /* Write a temporary file, then rename it, so that concurrent readers see all of it or nothing */
    const std::string path = fileFor(key), temporary = fmt::format("{}.{}.{}", path, getpid(), std::random_device{}());
    {
        std::ofstream file(temporary, std::ios::binary);
        file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        file.close();
        if (!file) { std::remove(temporary.c_str()); return; }
    }
    if (std::rename(temporary.c_str(), path.c_str()) != 0) std::remove(temporary.c_str());
}

int ProgramCache::clear() const {
    int count = 0;
    std::error_code error;
    for (fs::directory_iterator i(folder_, error), end; !error && i != end; i.increment(error)) {
        std::error_code ignored;
        const std::string name = i->path().filename().string();
        if (name.ends_with(".program")) count += fs::remove(i->path(), ignored);
        else if (name.find(".program.") != std::string::npos) fs::remove(i->path(), ignored);   // left by a killed store()
        else if (i->path().filename() == "pocl") fs::remove_all(i->path(), ignored);   // from versions that shared PoCL's files
    }
    return count;
}

/// Free bytes in a folder; 0 if it is not writable or is mounted noexec.
static std::uintmax_t roomForPrograms(const fs::path& folder) {
    struct statvfs status {};
    if (::access(folder.c_str(), W_OK | X_OK) != 0 || ::statvfs(folder.c_str(), &status) != 0 || (status.f_flag & ST_NOEXEC)) return 0;
    return static_cast<std::uintmax_t>(status.f_bavail) * status.f_frsize;
}

/// The folder for PoCL's files, in memory if possible, because PoCL waits for the disk after each file. The first candidate with room for
/// the kernels of a large scene, else the one with the most room.
static std::string placeForPocl(const std::string& cacheFolder) {
    constexpr std::uintmax_t enough = 128u << 20;
    std::error_code error;
    std::string best;
    std::uintmax_t most = 0;
    for (const fs::path& folder : {fs::path("/dev/shm"), fs::temp_directory_path(error), fs::path(cacheFolder)}) {
        const std::uintmax_t room = std::min(roomForPrograms(folder), enough);
        if (room > most) {
            most = room;
            best = folder.string();
        }
    }
    return best;
}

void preparePocl(const std::string& cacheFolder) {
    /* Otherwise PoCL compiles each kernel again for other grid sizes; straight-line loops over a fixed group gain nothing from that
       (docs/performance.md) */
    setenv("POCL_WORK_GROUP_SPECIALIZATION", "0", 0);
    /* PoCL 3.1 sets this variable while it opens its devices, when other threads may be reading the environment. If the variable exists
       already, setenv replaces its value in place and the environment does not move */
    setenv("HWLOC_PLUGINS_PATH", "/dev/null", 0);
    if (std::getenv("POCL_CACHE_DIR")) return;
    static const PrivateFolder own(placeForPocl(cacheFolder));
    if (!own.path().empty()) setenv("POCL_CACHE_DIR", own.path().c_str(), 0);
}

}  // namespace eikonal
