// Lanes of eight words: those that are chosen, and lists of them.

#include "device_function.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>

namespace eikonal {
namespace {

using Words = std::array<uint, 8>;
const char* const words = "typedef struct { uint word[8]; } eight_words;";

TEST(Wide, StoresTheLanesWhoseBitsAreSetInOrder) {
    const DeviceFunction<Words> store({.include = "math/wide.clh",
                                       .type = "eight_words",
                                       .body = "store_chosen_lanes((uint8)(10u, 11u, 12u, 13u, 14u, 15u, 16u, 17u), bits, result.word);",
                                       .inputs = {"uint bits"},
                                       .declarations = words});
    std::vector<uint> bits(256);
    std::iota(bits.begin(), bits.end(), 0u);
    const std::vector<Words> stored = store(bits);
    for (const uint b : bits) {
        uint next = 0;
        for (uint lane = 0; lane < 8; ++lane) {
            if (!(b >> lane & 1)) continue;
            EXPECT_EQ(stored[b][next++], 10 + lane) << b;
        }
    }
}

TEST(Wide, TakesLanesFromAList) {
    const DeviceFunction<Words> permute({.include = "math/wide.clh",
                                         .type = "eight_words",
                                         .body = "vstore8(permute_lanes((uint8)(10u, 11u, 12u, 13u, 14u, 15u, 16u, 17u), "
                                                 "list_lanes(list)), 0, result.word);",
                                         .inputs = {"uint list"},
                                         .declarations = words});
    const std::vector<Words> taken = permute(std::vector<uint>{0x76543210u, 0x01234567u, 0x77777777u, 0x31402756u});
    EXPECT_EQ(taken[0], (Words{10, 11, 12, 13, 14, 15, 16, 17}));
    EXPECT_EQ(taken[1], (Words{17, 16, 15, 14, 13, 12, 11, 10}));
    EXPECT_EQ(taken[2], (Words{17, 17, 17, 17, 17, 17, 17, 17}));
    EXPECT_EQ(taken[3], (Words{16, 15, 17, 12, 10, 14, 11, 13}));
}

}  // namespace
}  // namespace eikonal
