#pragma once
// Tables of names and values.

#include <algorithm>
#include <cstddef>
#include <utility>

namespace eikonal {

/// The first name of `value` in an array of (name, value) pairs. The array must have the value.
template <class Value, std::size_t count> const char* nameIn(const std::pair<const char*, Value> (&names)[count], Value value) {
    return std::ranges::find(names, value, &std::pair<const char*, Value>::second)->first;
}

}  // namespace eikonal
