#pragma once
// Hashes of packed scenes.

#include "device/source.h"
#include "eikonal/scene.h"
#include "memory_pages.h"

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace eikonal {

/// A hash of the tables and settings that are added, in order.
class TableHash {
public:
    template <class Element> void add(const Table<Element>& table) {
        hash_ = hashBytes({reinterpret_cast<const char*>(table.data()), table.size() * sizeof(Element)}, hash_);
    }
    /// Without the seed, and without what follows from the numbers of samples and pixels.
    void add(const settings& frame) {
        settings same = frame;
        same.seed = same.sequence_sample_bits = same.sequence_tile_bits = 0;
        hash_ = hashBytes({reinterpret_cast<const char*>(&same), sizeof same}, hash_);
    }
    /// 16 hexadecimal digits.
    std::string text() const { return fmt::format("{:016x}", hash_); }

private:
    std::uint64_t hash_ = hashSeed;
};

}  // namespace eikonal
