#include "film/sample_nodes.h"

#include <algorithm>

namespace eikonal {

SampleRange rangeOf(unsigned samples, SampleShare share) {
    const auto border = [&](unsigned i) {
        return static_cast<unsigned>(std::min<std::uint64_t>(std::uint64_t(leavesOf(samples)) * i / share.count * leafSamples, samples));
    };
    return {border(share.index - 1), border(share.index)};
}

/// Whether a range is a whole node.
static bool isWhole(SampleRange range) {
    std::uint64_t size = leafSamples;
    while (size < range.length()) size *= nodeChildren;
    return size == range.length() && range.first % size == 0;
}

bool joins(SampleRange node, SampleRange next) {
    if (node.end != next.first || !isWhole(next)) return false;
    const std::uint64_t parent = std::uint64_t(next.length()) * nodeChildren;
    return node.first < next.first && node.first == next.first - next.first % parent;
}

std::vector<SampleRange> nodesOf(SampleRange range) {
    std::vector<SampleRange> nodes;
    for (unsigned begin = range.first; begin < range.end;) {
        std::uint64_t size = leafSamples;
        while (begin % (size * nodeChildren) == 0 && size * nodeChildren <= range.end - begin) size *= nodeChildren;
        const bool isNode = begin % leafSamples == 0 && size <= range.end - begin;
        const std::uint64_t end = isNode ? begin + size : std::min<std::uint64_t>(std::uint64_t{leafBegin(begin)} + leafSamples, range.end);
        SampleRange next{begin, static_cast<unsigned>(end)};
        begin = next.end;
        while (!nodes.empty() && joins(nodes.back(), next)) {
            next.first = nodes.back().first;
            nodes.pop_back();
        }
        nodes.push_back(next);
    }
    return nodes;
}

}  // namespace eikonal
