// Parts of an image by rows of equal cost.

#include "film/tile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace eikonal {
namespace {

/// The parts of rows with these costs, checked: one after the other, all rows, none empty.
std::vector<PixelRect> parts(const PixelRect& all, const std::vector<std::uint64_t>& costs, int count) {
    std::vector<PixelRect> found;
    for (int i = 1; i <= count; ++i) {
        found.push_back(rowsOf(all, {i, count}, costs));
        EXPECT_EQ(found.back().y0, i == 1 ? all.y0 : found[found.size() - 2].y1);
        EXPECT_LT(found.back().y0, found.back().y1);
        EXPECT_EQ(found.back().x0, all.x0);
        EXPECT_EQ(found.back().x1, all.x1);
    }
    EXPECT_EQ(found.back().y1, all.y1);
    return found;
}

TEST(TilesByCost, DivideTheCost) {
    std::vector<std::uint64_t> costs(200, 10);
    std::fill(costs.begin() + 150, costs.end(), 90);   // 1500 + 4500
    const std::vector<PixelRect> found = parts({3, 5, 9, 205}, costs, 4);
    EXPECT_EQ(found[0].y1, 5 + 150) << "a quarter";
    EXPECT_NEAR(found[1].y1, 5 + 150 + 1500 / 90., 1);
    EXPECT_NEAR(found[2].y1, 5 + 150 + 3000 / 90., 1);
}

TEST(TilesByCost, HaveARowEach) {
    std::vector<std::uint64_t> costs(12, 1);
    for (const size_t dear : {size_t{0}, size_t{5}, size_t{11}}) {
        costs.assign(12, 1);
        costs[dear] = 1000000;
        for (const int count : {1, 2, 5, 11, 12}) parts({0, 0, 4, 12}, costs, count);
    }
}

/// No part costs more than its share by more than the dearest row.
TEST(TilesByCost, AreWithinARowOfTheirShare) {
    std::mt19937 random(1);
    std::vector<std::uint64_t> costs(500);
    for (std::uint64_t& cost : costs) cost = 1 + random() % 100;
    const std::uint64_t total = std::accumulate(costs.begin(), costs.end(), std::uint64_t{0});
    for (const int count : {2, 7, 8, 30})
        for (const PixelRect& part : parts({0, 0, 1, 500}, costs, count)) {
            const std::uint64_t cost = std::accumulate(costs.begin() + part.y0, costs.begin() + part.y1, std::uint64_t{0});
            EXPECT_NEAR(static_cast<double>(cost), static_cast<double>(total) / count, 101);
        }
}

}  // namespace
}  // namespace eikonal
