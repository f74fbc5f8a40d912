// Which blocks get more samples, decided from numbers; and how blocks are dealt out in batches.

#include "render/adaptive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace eikonal {
namespace {

/// Blocks of 256 pixels with 16 samples, whose variances are spread over six powers of ten.
std::vector<BlockNoise> noisyBlocks(int count) {
    std::mt19937 random(1);
    std::vector<BlockNoise> blocks;
    for (int i = 0; i < count; ++i) {
        const double deviation = std::exp2(10.0 * (static_cast<double>(random()) / 4294967296.0) - 4);
        blocks.push_back({16, 256, deviation * deviation, deviation});
    }
    return blocks;
}

std::vector<BlockNoise> withSamples(std::vector<BlockNoise> blocks, const std::vector<unsigned>& samples) {
    for (size_t i = 0; i < blocks.size(); ++i) blocks[i].samples = samples[i];
    return blocks;
}

constexpr unsigned unlimited = 1u << 30;

TEST(PlanSamples, TheErrorIsAsAskedAndNotMuchLess) {
    const auto blocks = noisyBlocks(500);
    for (double target : {1.0, 0.1, 0.001}) {
        const double error = expectedError(withSamples(blocks, planSamples(blocks, target, unlimited)));
        EXPECT_LE(error, target);
        EXPECT_GT(error, 0.95 * target);
    }
}

// Of all ways to come down to an error, samples in proportion to standard deviations take the fewest: (mean deviation)^2 / error a pixel.
// Powers of two in place of them cost 4 % (the mean of q and of 1/q, for q evenly spread between 1/sqrt(2) and sqrt(2) in its
// logarithm: 1.0202^2).
TEST(PlanSamples, CostsHardlyMoreThanTheLeastThatIsPossible) {
    const auto blocks = noisyBlocks(2000);
    constexpr double target = 1e-4;   // where 16 samples are too few everywhere
    double deviations = 0, samples = 0;
    for (unsigned n : planSamples(blocks, target, unlimited)) samples += n;
    for (const BlockNoise& b : blocks) deviations += std::sqrt(b.variance);
    const double least = deviations * deviations / target / static_cast<double>(blocks.size());
    EXPECT_GT(samples / least, 1);
    EXPECT_LT(samples / least, 1.06);
}

TEST(PlanSamples, ABlockHasWhatItHadTimesAPowerOfTwoOrTheMost) {
    const auto blocks = noisyBlocks(500);
    for (unsigned n : planSamples(blocks, 0.001, 3000)) EXPECT_TRUE(n == 3000 || (n % 16 == 0 && std::has_single_bit(n / 16))) << n;
    for (unsigned n : planSamples(blocks, 1e-12, 3000)) EXPECT_EQ(n, 3000u) << "the target is out of reach";
}

TEST(PlanSamples, NothingMoreWhereTheErrorIsSmallEnough) {
    const auto blocks = noisyBlocks(500);
    for (unsigned n : planSamples(blocks, expectedError(blocks), unlimited)) EXPECT_EQ(n, 16u);
    const std::vector<BlockNoise> even(9, {16, 256, 0, 0});
    for (unsigned n : planSamples(even, 1e-9, unlimited)) EXPECT_EQ(n, 16u);
}

TEST(PlanSamples, LargerBlocksCountMore) {
    const std::vector<BlockNoise> blocks{{1, 256, 1, 1}, {1, 16, 16, 4}};
    EXPECT_DOUBLE_EQ(expectedError(blocks), (256 * 1 + 16 * 16) / 272.0);
}

// One noisy block in the middle of 9 x 9: its eight neighbours are taken to have the mean deviation of the nine, 1/9 of its own, and all
// others half of the image's, 1/162.
TEST(SuspectNoise, OfABlockBesideANoisyOneMoreThanOfOthers) {
    std::vector<BlockNoise> blocks(81, {16, 256, 0, 0});
    blocks[40].variance = 81;
    suspectNoise(blocks, 9);
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x) {
            const bool middle = x == 4 && y == 4, near = std::abs(x - 4) <= 1 && std::abs(y - 4) <= 1;
            EXPECT_NEAR(blocks[static_cast<size_t>(9 * y + x)].suspected, middle ? 9 : near ? 1 : 9.0 / 162, 1e-12) << x << " " << y;
        }
}

TEST(SuspectNoise, OfEvenNoiseNothingMore) {
    std::vector<BlockNoise> blocks(6, {16, 256, 4, 0});
    suspectNoise(blocks, 3);
    for (const BlockNoise& b : blocks) EXPECT_DOUBLE_EQ(b.suspected, 2);
}

TEST(Batches, DealOutEverySampleInOrderAndFillWaves) {
    const std::vector<Block> blocks{{0, 0, 16, 16}, {16, 0, 32, 32}, {0, 16, 64, 64}, {16, 16, 16, 1}, {32, 16, 16, 7}};
    for (unsigned mostPaths : {256u, 1000u, 5000u, 131008u}) {
        std::vector<unsigned> next;
        for (const Block& b : blocks) next.push_back(b.firstSample);
        Batches batches({4, 4}, blocks, mostPaths);
        while (!batches.empty()) {
            const Batch batch = batches.next();
            EXPECT_LE(batch.paths(), mostPaths);
            if (!batches.empty()) { EXPECT_GT(batch.paths() + 256, mostPaths) << "room for a layer is left"; }
            for (const Block& b : batch.blocks) {
                const auto whole = std::ranges::find_if(blocks, [&](const Block& w) { return w.x == b.x && w.y == b.y; });
                unsigned& expected = next[static_cast<size_t>(whole - blocks.begin())];
                EXPECT_EQ(b.firstSample, expected);
                expected += b.samples;
            }
        }
        for (size_t i = 0; i < blocks.size(); ++i) EXPECT_EQ(next[i], blocks[i].firstSample + blocks[i].samples) << mostPaths;
    }
}

}  // namespace
}  // namespace eikonal
