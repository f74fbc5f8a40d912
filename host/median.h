#pragma once

#include <algorithm>
#include <vector>

namespace eikonal {

/// The median of at least one value; of an even number, the mean of the two middle values.
inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const size_t n = values.size();
    return n % 2 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

}  // namespace eikonal
