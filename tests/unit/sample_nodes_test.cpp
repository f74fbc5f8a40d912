// The tree over a pixel's samples: its nodes depend on indices only, so ranges join in any way to the same ones.

#include "film/sample_nodes.h"

#include <gmock/gmock.h>

namespace eikonal {
namespace {

constexpr unsigned leaf = leafSamples, node = leafSamples * nodeChildren;

/// The nodes of `range` and then those of the next one, joined from the left.
std::vector<SampleRange> appended(std::vector<SampleRange> nodes, SampleRange next) {
    for (SampleRange range : nodesOf(next)) {
        while (!nodes.empty() && joins(nodes.back(), range)) {
            range.first = nodes.back().first;
            nodes.pop_back();
        }
        nodes.push_back(range);
    }
    return nodes;
}

TEST(SampleNodes, OneRunKeepsFew) {
    EXPECT_EQ(nodesOf({0, 0}).size(), 0u);
    for (const unsigned end : {1u, leaf, 2 * leaf, node, 3 * node, 16 * node, 48 * node}) EXPECT_EQ(nodesOf({0, end}).size(), 1u) << end;
    EXPECT_THAT(nodesOf({0, 2 * node + 3 * leaf + 1}),
                testing::ElementsAre(SampleRange{0, 2 * node}, SampleRange{2 * node, 2 * node + 3 * leaf},
                                     SampleRange{2 * node + 3 * leaf, 2 * node + 3 * leaf + 1}));
    EXPECT_LE(nodesOf({0, 4'294'967'295u}).size(), 8u);
}

/// Shares are whole leaves that follow each other, and none has two leaves more than another.
TEST(SampleNodes, SharesAreAllSamplesInEqualRanges) {
    for (const unsigned samples : {1u, leaf - 1, leaf, 3 * leaf + 5, 1000u, 4 * node, 4'294'967'295u})
        for (const unsigned count : {1u, 2u, 3u, 7u, 64u}) {
            if (count > leavesOf(samples)) continue;
            unsigned next = 0, fewest = leavesOf(samples), most = 0;
            for (unsigned index = 1; index <= count; ++index) {
                const SampleRange range = rangeOf(samples, {index, count});
                EXPECT_EQ(range.first, next);
                EXPECT_TRUE(range.end % leaf == 0 || range.end == samples) << range.end;
                fewest = std::min(fewest, leavesOf(range.length()));
                most = std::max(most, leavesOf(range.length()));
                next = range.end;
            }
            EXPECT_EQ(next, samples) << count;
            EXPECT_TRUE(fewest > 0 && most <= fewest + 1) << samples << " samples in " << count << " shares";
        }
}

TEST(SampleNodes, RangesJoinToTheNodesOfOneRun) {
    for (unsigned end = leaf; end < 3 * node; end += 7 * leaf)
        for (unsigned first = 0; first < end; first += 5 * leaf)
            for (unsigned second = first; second < end; second += 11 * leaf) {
                const auto nodes = appended(appended(nodesOf({0, first}), {first, second}), {second, end});
                EXPECT_EQ(nodes, nodesOf({0, end})) << first << " " << second << " " << end;
            }
}

TEST(SampleNodes, ARangeCoversItsSamples) {
    for (const SampleRange range :
         {SampleRange{3 * leaf, 3 * leaf + 1}, SampleRange{5 * leaf, 40 * leaf + 2}, SampleRange{node, 17 * node}}) {
        unsigned at = range.first;
        for (const SampleRange part : nodesOf(range)) {
            EXPECT_EQ(part.first, at);
            at = part.end;
        }
        EXPECT_EQ(at, range.end);
    }
}

}  // namespace
}  // namespace eikonal
