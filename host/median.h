#pragma once

#include <algorithm>
#include <vector>

namespace eikonal {

/// The middle one of some values, of which there is at least one; of an even number of them the mean of the two in the middle.
inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const size_t n = values.size();
    return n % 2 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

}  // namespace eikonal
