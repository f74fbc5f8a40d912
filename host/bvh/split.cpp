#include "bvh/split.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>

namespace eikonal {

constexpr int maxBins = 32;
/// From this size on, bins are filled in parallel.
constexpr uint parallelSize = 1u << 16;

/// Maps centroids to bins, on each axis.
struct Binning {
    float4 offset, scale;
    int bins;

    explicit Binning(const Range& range)
        : offset(range.centroids.low), bins(static_cast<int>(std::min<uint>(maxBins, 4 + range.size() / 4))) {
        const float4 extent = range.centroids.high - range.centroids.low;
        for (int axis = 0; axis < 4; ++axis)
            scale[axis] = axis < 3 && extent[axis] > 1e-30f ? 0.9999f * static_cast<float>(bins) / extent[axis] : 0.f;
    }
    int4 operator()(const Reference& r) const { return __builtin_convertvector((r.centroid() - offset) * scale, int4); }
    /// The bin on one axis, to the bit: partitioning must agree with the counts.
    int on(int axis, const Reference& r) const {
        return static_cast<int>((r.box.low[axis] + r.box.high[axis] - offset[axis]) * scale[axis]);
    }
};

/// Counts and bounds of each bin.
struct Bins {
    std::array<std::array<WideBox, maxBins>, 3> boxes;
    std::array<std::array<uint, maxBins>, 3> counts;

    explicit Bins(int bins) {
        for (int axis = 0; axis < 3; ++axis) {
            std::fill_n(boxes[axis].begin(), bins, WideBox::empty());
            std::fill_n(counts[axis].begin(), bins, 0u);
        }
    }
    void add(std::span<const Reference> references, const Binning& binning) {
        for (const Reference& r : references) {
            const int4 bin = binning(r);
            for (int axis = 0; axis < 3; ++axis) {
                boxes[axis][bin[axis]].grow(r.box);
                ++counts[axis][bin[axis]];
            }
        }
    }
    void add(const Bins& other, int bins) {
        for (int axis = 0; axis < 3; ++axis)
            for (int i = 0; i < bins; ++i) {
                boxes[axis][i].grow(other.boxes[axis][i]);
                counts[axis][i] += other.counts[axis][i];
            }
    }
};

/// A split: bins below `bin` on `axis` go left. Without an axis there is no split.
struct Cut {
    int axis = -1, bin = 0;
    float cost = std::numeric_limits<float>::max();
};

/// Leaves test eight elements at once, so cost counts blocks, not triangles.
static float blocksOf(uint count) { return static_cast<float>((count + BVH_WIDTH - 1) / BVH_WIDTH); }

static Cut bestCut(const Bins& in, const Binning& binning) {
    Cut best;
    const int bins = binning.bins;
    for (int axis = 0; axis < 3; ++axis) {
        if (binning.scale[axis] == 0) continue;
        /* Sweep from the right: cost of everything above each border */
        std::array<float, maxBins> above;
        WideBox box = WideBox::empty();
        uint count = 0;
        for (int i = bins - 1; i > 0; --i) {
            box.grow(in.boxes[axis][i]);
            count += in.counts[axis][i];
            above[i] = count ? box.halfArea() * blocksOf(count) : -1.f;
        }
        /* Sweep from the left, and combine */
        box = WideBox::empty();
        count = 0;
        for (int i = 1; i < bins; ++i) {
            box.grow(in.boxes[axis][i - 1]);
            count += in.counts[axis][i - 1];
            if (count == 0 || above[i] < 0) continue;
            const float cost = box.halfArea() * blocksOf(count) + above[i];
            if (cost < best.cost) best = {axis, i, cost};
        }
    }
    return best;
}

static Bins fillBins(std::span<const Reference> references, const Range& range, const Binning& binning) {
    Bins all(binning.bins);
    if (range.size() < parallelSize) {
        all.add(references.subspan(range.begin, range.size()), binning);
    } else {
        /* Minima, maxima and counts do not depend on the order of the reduction */
        all = tbb::parallel_reduce(
            tbb::blocked_range<uint>(range.begin, range.end, parallelSize / 4), all,
            [&](const tbb::blocked_range<uint>& part, Bins bins) {
                bins.add(references.subspan(part.begin(), part.size()), binning);
                return bins;
            },
            [&](Bins a, const Bins& b) { a.add(b, binning.bins); return a; });
    }
    return all;
}

Range measureRange(std::span<const Reference> references, uint begin, uint end) {
    Range range;
    if (end - begin < parallelSize) {
        for (uint i = begin; i < end; ++i) range.include(references[i]);
    } else {
        range = tbb::parallel_reduce(
            tbb::blocked_range<uint>(begin, end, parallelSize / 4), range,
            [&](const tbb::blocked_range<uint>& part, Range sum) {
                for (uint i = part.begin(); i < part.end(); ++i) sum.include(references[i]);
                return sum;
            },
            [](Range a, const Range& b) { a.include(b); return a; });
    }
    range.begin = begin; range.end = end;
    return range;
}

static std::pair<Range, Range> cutAt(std::span<const Reference> references, const Range& range, uint middle) {
    return {measureRange(references, range.begin, middle), measureRange(references, middle, range.end)};
}

std::pair<Range, Range> splitByCost(std::span<Reference> references, const Range& range) {
    if (range.size() == 2) return cutAt(references, range, range.begin + 1);
    const Binning binning(range);
    const Cut cut = bestCut(fillBins(references, range, binning), binning);
    if (cut.axis < 0) return cutAt(references, range, range.begin + range.size() / 2);

    /* Measure both halves while partitioning */
    Range left, right;
    uint low = range.begin, high = range.end;
    for (;;) {
        while (low < high && binning.on(cut.axis, references[low]) < cut.bin) left.include(references[low++]);
        while (low < high && binning.on(cut.axis, references[high - 1]) >= cut.bin) right.include(references[--high]);
        if (low == high) break;
        std::swap(references[low], references[high - 1]);
    }
    left.begin = range.begin; left.end = low;
    right.begin = low; right.end = range.end;
    return {left, right};
}

std::pair<Range, Range> splitInHalves(std::span<Reference> references, const Range& range) {
    const float4 extent = range.centroids.high - range.centroids.low;
    const int axis = extent[0] > extent[1] ? (extent[0] > extent[2] ? 0 : 2) : (extent[1] > extent[2] ? 1 : 2);
    const uint middle = range.begin + range.size() / 2;
    std::nth_element(references.begin() + range.begin, references.begin() + middle, references.begin() + range.end,
                     [axis](const Reference& a, const Reference& b) { return a.centroid()[axis] < b.centroid()[axis]; });
    return cutAt(references, range, middle);
}

}  // namespace eikonal
