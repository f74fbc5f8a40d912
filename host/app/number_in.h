#pragma once
// Numbers on the command line.

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

namespace eikonal {

/// All of `text` as one finite number, or nothing.
template <class Number> std::optional<Number> numberIn(const std::string& text) {
    Number value{};
    const char* begin = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    if constexpr (std::is_floating_point_v<Number>)
        if (!std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace eikonal
