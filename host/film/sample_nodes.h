#pragma once
// How a pixel's samples are added up: in the nodes of a tree over their indices, whose shape depends on nothing else. So the sums of any
// ranges of samples join to the sums of one run, bit for bit.

#include <compare>
#include <cstdint>
#include <variant>
#include <vector>

namespace eikonal {

/// Samples first <= i < end of a pixel.
struct SampleRange {
    unsigned first = 0, end = 0;
    unsigned length() const { return end - first; }
    auto operator<=>(const SampleRange&) const = default;
};

/// The device adds up this many samples one after the other; a leaf begins at a multiple of it. Ranges that are to join begin and end at
/// such a multiple, or at the last sample.
constexpr unsigned leafSamples = 16;
/// A node has as many children, which the host adds one after the other: nodes have 16, 256, 4096 ... samples.
constexpr unsigned nodeChildren = 16;

/// Part `index` of 1 ... `count` of a pixel's samples.
struct SampleShare {
    unsigned index = 1, count = 1;
};
using SampleSelection = std::variant<SampleRange, SampleShare>;

/// Where the leaf that holds a sample begins and ends.
constexpr unsigned leafBegin(unsigned sample) { return sample - sample % leafSamples; }
constexpr unsigned leafEnd(unsigned sample) { return leafBegin(sample) + leafSamples; }

/// The number of leaves of a pixel's first `samples` samples; the last may be a part of one.
constexpr unsigned leavesOf(unsigned samples) { return samples / leafSamples + (samples % leafSamples != 0); }
/// The samples of a share of the first `samples`: whole leaves, and what is left at the end. Shares differ by a leaf at most. There must be
/// as many leaves as shares.
SampleRange rangeOf(unsigned samples, SampleShare share);

/// Whether the sums of `next` are added to those of `node`: `next` is a whole node, and `node` is its earlier siblings.
bool joins(SampleRange node, SampleRange next);

/// The nodes whose sums are kept of a range: whole nodes, first children of nodes, and part of a leaf. A few, if it begins at 0 or at a
/// large node; one, if it also ends there.
std::vector<SampleRange> nodesOf(SampleRange range);

}  // namespace eikonal
