#pragma once
// How a pixel's samples are added up: in the nodes of a tree over their indices, whose shape depends on nothing else. So the sums of any
// ranges of samples join to the sums of one run, bit for bit.

#include <compare>
#include <cstdint>
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

/// Where the leaf that holds a sample begins and ends.
constexpr unsigned leafBegin(unsigned sample) { return sample - sample % leafSamples; }
constexpr unsigned leafEnd(unsigned sample) { return leafBegin(sample) + leafSamples; }

/// Whether the sums of `next` are added to those of `node`: `next` is a whole node, and `node` is its earlier siblings.
bool joins(SampleRange node, SampleRange next);

/// The nodes whose sums are kept of a range: whole nodes, first children of nodes, and part of a leaf. A few, if it begins at 0 or at a
/// large node; one, if it also ends there.
std::vector<SampleRange> nodesOf(SampleRange range);

}  // namespace eikonal
