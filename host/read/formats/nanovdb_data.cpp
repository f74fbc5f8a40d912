#include "read/formats/nanovdb_data.h"

#include "available_memory.h"
#include "read/formats/read_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace eikonal {
namespace {

using nanovdb::io::Codec;

/// More than zlib compresses: 1032 times. Blosc's codecs compress less.
constexpr std::uint64_t mostTimes = 1100;

/// The next piece of compressed data, whose size precedes it. left: bytes of the grid in the file that have not been read.
std::vector<char> readPiece(std::istream& file, std::uint64_t& left) {
    std::uint64_t size = 0;
    readRaw(file, &size, sizeof size);
    if (left < sizeof size || size > left - sizeof size) throw ReadProblem("is damaged: a size in its data is beyond its end");
    left -= sizeof size + size;
    std::vector<char> piece(size);
    readRaw(file, piece.data(), piece.size());
    return piece;
}

void inflate(const std::vector<char>& piece, std::uint8_t* to, std::uint64_t size) {
    uLongf bytes = size;
    const auto* from = reinterpret_cast<const Bytef*>(piece.data());
    if (uncompress(to, &bytes, from, piece.size()) != Z_OK || bytes != size)
        throw ReadProblem("is damaged: its compressed data is not what was written");
}

/// Blosc's function reads as much as the header of its data says.
void decompressBlosc(const std::vector<char>& piece, std::uint8_t* to, std::uint64_t size) {
    std::size_t bytes = 0;
    if (piece.size() < BLOSC_MIN_HEADER_LENGTH || blosc_cbuffer_validate(piece.data(), piece.size(), &bytes) != 0 || bytes != size ||
        blosc_decompress_ctx(piece.data(), to, size, 1) != static_cast<int>(size))
        throw ReadProblem("is damaged: its compressed data is not what was written");
}

}  // namespace

void readRaw(std::istream& file, void* to, std::size_t size) {
    if (size == 0) return;
    file.read(static_cast<char*>(to), static_cast<std::streamsize>(size));
    if (!file) throw ReadProblem("ends too early");
}

nanovdb::GridHandle<> readGrid(std::istream& file, const nanovdb::io::MetaData& meta, Codec codec) {
    const std::uint64_t size = meta.gridSize, most = codec == Codec::NONE ? meta.fileSize : mostTimes * meta.fileSize;
    if (size > most || size == 0)
        throw ReadProblem(fmt::format("is damaged: {} bytes of it cannot hold a grid of {} bytes", meta.fileSize, size));
    if (size > availableMemory() / 2) throw ReadProblem("has a grid that does not fit into memory");
    nanovdb::GridHandle<> handle(nanovdb::HostBuffer::create(size));
    if (!handle.data()) throw ReadProblem("has a grid that does not fit into memory");

    constexpr std::uint64_t piece = std::uint64_t(1) << 30;   // of Blosc's, as the library writes them
    std::uint64_t left = meta.fileSize;
    switch (codec) {
        case Codec::NONE: readRaw(file, handle.data(), size); break;
        case Codec::ZIP: inflate(readPiece(file, left), handle.data(), size); break;
        case Codec::BLOSC:
            for (std::uint64_t done = 0; done < size; done += piece)
                decompressBlosc(readPiece(file, left), handle.data() + done, std::min(size - done, piece));
            break;
        default:
            throw ReadProblem(fmt::format("is compressed by codec {}; known are none (0), ZIP (1) and Blosc (2)", static_cast<int>(codec)));
    }
    return handle;
}

}  // namespace eikonal
