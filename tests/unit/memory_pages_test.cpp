// Memory straight from the system: aligned, zero, and vectors in it.

#include "memory_pages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <numeric>
#include <vector>

namespace eikonal {
namespace {

bool isAligned(const void* memory, std::size_t bytes) { return reinterpret_cast<std::uintptr_t>(memory) % bytes == 0; }

TEST(MemoryPages, AreZerosFromTheBorderOfALargePageOn) {
    for (const PageSize size : {PageSize::small, PageSize::large})
        for (const std::size_t bytes : {std::size_t{1}, largePage - 1, largePage, 2 * largePage + 1}) {
            auto* pages = static_cast<char*>(mapPages(bytes, size));
            ASSERT_TRUE(pages);
            EXPECT_TRUE(isAligned(pages, largePage));
            EXPECT_TRUE(std::all_of(pages, pages + bytes, [](char c) { return c == 0; }));
            std::fill_n(pages, bytes, 'x');
            unmapPages(pages, bytes);
        }
}

/// An address space has 2^47 bytes.
TEST(MemoryPages, AreNullWhereThereIsNotEnough) { EXPECT_EQ(mapPages(std::size_t{1} << 50, PageSize::small), nullptr); }

/// Small allocations lie behind each other in pages that they share, are apart, and stay after others have gone.
TEST(MemoryPages, AreSharedBySmallAllocations) {
    std::vector<std::shared_ptr<void>> all;
    for (int i = 0; i < 100; ++i) {
        const std::size_t bytes = i == 50 ? worthPages - 1 : std::size_t{1000} * (i + 1);
        all.push_back(sharePages(bytes));
        auto* const begin = static_cast<char*>(all.back().get());
        ASSERT_TRUE(begin);
        EXPECT_TRUE(isAligned(begin, 128));
        EXPECT_TRUE(std::all_of(begin, begin + bytes, [](char c) { return c == 0; })) << i;
        std::fill_n(begin, bytes, static_cast<char>(i + 1));
    }
    for (std::size_t i = 0; i < all.size(); i += 2) all[i].reset();
    for (int i = 1; i < 100; i += 2) {
        const auto* const begin = static_cast<const char*>(all[static_cast<std::size_t>(i)].get());
        EXPECT_TRUE(std::all_of(begin, begin + std::size_t{1000} * (i + 1), [&](char c) { return c == static_cast<char>(i + 1); })) << i;
    }
    const auto first = sharePages(1), second = sharePages(1);
    EXPECT_EQ(static_cast<char*>(second.get()) - static_cast<char*>(first.get()), 128);
}

/// A table goes from the heap to pages of its own as it grows, and keeps what it holds.
TEST(MemoryPages, TablesGrowIntoThem) {
    Table<std::uint32_t> table;
    for (std::uint32_t i = 0; i < 2 * worthPages / sizeof i; ++i) table.push_back(i);
    EXPECT_TRUE(isAligned(table.data(), largePage));
    Table<std::uint32_t> expected(table.size());
    std::iota(expected.begin(), expected.end(), 0u);
    EXPECT_EQ(table, expected);
    EXPECT_TRUE(isAligned(Table<char>(1).data(), 64));
}

}  // namespace
}  // namespace eikonal
