#pragma once
// The bytes of a grid in a NanoVDB file, which may be compressed. The library's own function trusts every size that the file holds.

/* Files may use either compression */
#define NANOVDB_USE_ZIP
#define NANOVDB_USE_BLOSC
#include <nanovdb/util/IO.h>

#include <cstddef>
#include <istream>

namespace eikonal {

/// Throws ReadProblem at the end of the file.
void readRaw(std::istream& file, void* to, std::size_t size);

/// The grid with this header, decompressed; the file is at its data. Throws ReadProblem for sizes that cannot be, before memory is taken
/// for them, for compressed data that is damaged, and for a grid that does not fit into memory.
nanovdb::GridHandle<> readGrid(std::istream& file, const nanovdb::io::MetaData& meta, nanovdb::io::Codec codec);

}  // namespace eikonal
