#pragma once
// Adds what a film keeps of one range of samples to what it keeps of another.

#include "device/layout.h"
#include "film/pixel_row.h"
#include "film/sample_nodes.h"

#include <cstddef>
#include <span>
#include <vector>

namespace eikonal {

class JoinedSums {
public:
    /// layout: of the film's words. Throws std::logic_error for a field that it does not know how to add.
    explicit JoinedSums(const QueueLayout& layout);

    /// Replaces the samples `range` of `count` pixels by those and the samples `earlier`, which precede them. In double precision, and with
    /// the rounding errors that the film keeps, so that precision does not depend on the number of nodes.
    void join(PixelRow<const uint> earlier, SampleRange earlierRange, PixelRow<uint> row, SampleRange range, std::size_t count) const;

    /// All samples of `count` pixels whose nodes have these ranges and rows, in order; at least one.
    void joinAll(std::span<const SampleRange> nodes, std::span<const PixelRow<const uint>> rows, PixelRow<uint> total,
                 std::size_t count) const;

private:
    /* Each takes the words of the earlier samples and of the later ones, which become those of both */
    template <class Before, class Now> void joinLuminances(Before before, Now now, std::size_t count) const;
    template <class Before, class Now>
    void joinQuarters(Before before, Now now, unsigned length, unsigned more, std::size_t count) const;
    template <class Before, class Now> void keepEstimate(Before before, Now now, std::size_t count) const;
    template <class Before, class Now> void estimate(Before before, Now now, std::size_t i) const;
    struct Compensated { int sum, error; };      ///< words
    struct Vote { int id, lead; };
    std::size_t words_;                          ///< of a pixel
    std::vector<Compensated> compensated_;
    std::vector<int> plain_;                     ///< sums without rounding errors
    std::vector<int> counts_;                    ///< whole numbers
    std::vector<Vote> votes_;
    std::vector<int> mattes_;                    ///< first words of slots (join_mattes.h)
    int weight_, squareWeight_, mean_, spread_, quarter_, lowMean_, half_, quarterSquare_, eighth_;
    int quarterWeight_;                          ///< -1: without a filter
};

}  // namespace eikonal
