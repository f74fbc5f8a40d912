#pragma once
// Tables of names and what they name.

#include <algorithm>
#include <cstddef>
#include <utility>

namespace eikonal {

/// The first name of a value in an array of pairs of name and value, which has it.
template <class Value, std::size_t count> const char* nameIn(const std::pair<const char*, Value> (&names)[count], Value value) {
    return std::ranges::find(names, value, &std::pair<const char*, Value>::second)->first;
}

}  // namespace eikonal
