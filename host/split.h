#pragma once
// Texts that are lists.

#include <string>
#include <vector>

namespace eikonal {

/// The parts between separators, empty ones included; of a text without a separator, the text.
inline std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator) parts.emplace_back();
        else parts.back() += c;
    }
    return parts;
}

}  // namespace eikonal
