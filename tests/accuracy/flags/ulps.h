#pragma once
// Differences between floats in units in the last place.

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace eikonal {

/// The distance from |x| to the next larger float; that of the smallest normal float below it.
inline double unitInLastPlace(double x) {
    const double size = std::fabs(x);
    return std::ldexp(1.0, (size < 0x1p-126 ? -126 : std::ilogb(size)) - 23);
}

/// Largest and root mean square difference of values, in ulp.
struct UlpTally {
    double largest = 0, squares = 0;
    std::size_t values = 0;

    /// A difference, in ulp.
    void add(double difference) {
        largest = std::max(largest, difference);
        squares += difference * difference;
        ++values;
    }
    double rms() const { return values ? std::sqrt(squares / static_cast<double>(values)) : 0; }
};

}  // namespace eikonal
