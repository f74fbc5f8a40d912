#include "read/formats/read_bytes.h"

#include "read/formats/input_files.h"

#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace eikonal {

/// What a compressed file may hold: a small one can hold a thousand times its size, and fill the memory.
static constexpr std::size_t alwaysFine = 256 << 20;
static constexpr double highestCompression = 200;

static void refuseDevice(std::filesystem::file_type type) {
    if (type == std::filesystem::file_type::character || type == std::filesystem::file_type::block)
        throw ReadProblem("is a device, which may have no end");
}

/// All that zlib reads from an open file, which it passes through if it is not compressed. expected: its size, or 0 for a pipe. Closes it.
static std::vector<char> readAll(gzFile file, std::uintmax_t expected) {
    if (!file) throw ReadProblem(std::string("cannot be opened: ") + std::strerror(errno));
    gzbuffer(file, 1 << 20);
    std::vector<char> bytes;
    if (expected) bytes.reserve(expected + (1 << 16));
    int got = 0;
    do {
        const std::size_t size = bytes.size();
        const std::size_t room = std::clamp<std::size_t>(bytes.capacity() - size, 1 << 16, 1 << 24);
        bytes.resize(size + room);
        got = gzread(file, bytes.data() + size, static_cast<unsigned>(room));
        bytes.resize(size + static_cast<std::size_t>(std::max(got, 0)));
        if (expected && bytes.size() > alwaysFine &&
            static_cast<double>(bytes.size()) > highestCompression * static_cast<double>(expected)) {
            gzclose(file);
            throw ReadProblem(fmt::format("is compressed more than {} times, which no scene is: {} bytes hold more than {}",
                                          highestCompression, expected, alwaysFine));
        }
    } while (got > 0);
    int error = Z_OK;
    const std::string zlibReason = gzerror(file, &error);
    const std::string reason = error == Z_ERRNO ? std::strerror(errno) : zlibReason;
    gzclose(file);
    if (error == Z_BUF_ERROR) throw ReadProblem("is truncated: its compressed data ends too early");
    if (error != Z_OK) throw ReadProblem("cannot be read: " + reason);
    return bytes;
}

std::vector<char> readBytes(const std::string& path) {
    noteInputFile(path);
    std::error_code unknown;
    refuseDevice(std::filesystem::status(path, unknown).type());
    errno = 0;
    gzFile file = gzopen(path.c_str(), "rb");
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    return readAll(file, unknown ? 0 : size);
}

std::vector<char> readInputBytes() {
    const std::string input = "/dev/stdin";
    std::error_code unknown;
    refuseDevice(std::filesystem::status(input, unknown).type());
    errno = 0;
    const int copy = ::dup(STDIN_FILENO);
    gzFile file = copy < 0 ? nullptr : gzdopen(copy, "rb");
    const std::uintmax_t size = std::filesystem::file_size(input, unknown);
    return readAll(file, unknown ? 0 : size);
}

}  // namespace eikonal
