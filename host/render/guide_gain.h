#pragma once
// What a path guide gains, measured on paths that it guides.

#include <cstddef>
#include <vector>

namespace eikonal {

/// Paths are sampled by the guide and the BSDF together, with density q, and each tells what it would have told without the guide: a
/// contribution X has the second moment E_q[X^2] here, and E_p[X^2] = E_q[X^2 q / p] if the BSDF alone had sampled the directions before
/// it, with density p. The paths must not be among those that the guide has learned from.
class GuideGain {
public:
    /// The next paths begin, so many.
    void begin(std::size_t paths);
    /// The newest batch's path `path` has sampled a direction with density q; the BSDF alone: p. Both > 0.
    void sampled(std::size_t path, double q, double p);
    /// It has found light, as the image sees it.
    void found(std::size_t path, double light);

    /// The variance of a pixel without the guide over that with it, summed over the pixels, of which each has `samples` paths one after the
    /// other, 2 or more. The worst thousandth of the pixels does not count on either side. 1 without noise.
    double varianceRatio(std::size_t samples) const;

private:
    struct Path {
        double direct = 0;    ///< light found before the first guided direction: the same without the guide
        double guided = 0;    ///< and after it
        double squares = 0, squaresWithout = 0;   ///< of `guided`, event by event; times q / p
        double ratio = 1;     ///< q / p of the directions so far
        bool isGuided = false;
    };
    std::vector<Path> paths_;
    std::size_t first_ = 0;   ///< of the newest batch
};

}  // namespace eikonal
