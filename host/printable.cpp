#include "printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace eikonal {

/// Length in bytes of the UTF-8 character that a text begins with; 0 if it is invalid or not printable.
static size_t characterLength(std::string_view text) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) return (first >= 0x20 && first != 0x7f) || first == '\n' || first == '\t' ? 1 : 0;
    const size_t length = first >= 0xf0 && first < 0xf5 ? 4 : first >= 0xe0 && first < 0xf0 ? 3 : first >= 0xc2 && first < 0xe0 ? 2 : 0;
    if (length == 0 || text.size() < length) return 0;
    for (size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    const bool isControl = first == 0xc2 && byte(1) < 0xa0;
    return isControl ? 0 : length;
}

std::string printable(std::string_view text) {
    constexpr size_t longestWord = 5000;   // a path may have 4096 characters
    std::string result;
    size_t inWord = 0;
    while (!text.empty()) {
        inWord = std::isspace(static_cast<unsigned char>(text.front())) ? 0 : inWord + 1;
        if (inWord > longestWord) {
            const size_t rest = std::min(text.find_first_of(" \t\n"), text.size());
            result += fmt::format("... (and {} more characters)", rest);
            text.remove_prefix(rest);
            continue;
        }
        const size_t length = characterLength(text);
        if (length > 0) result += text.substr(0, length);
        else result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
        text.remove_prefix(std::max<size_t>(length, 1));
    }
    return result;
}

std::string inOneLine(std::string text) {
    for (size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) text.replace(at, 1, "\\x0a");
    return text;
}

std::string quoteWord(std::string_view word) {
    constexpr std::size_t longest = 40;
    const auto belongs = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || std::string_view("_.+-,<>").find(c) != std::string_view::npos;
    };
    if (word.size() > longest || !std::ranges::all_of(word, belongs))
        return fmt::format("a word of {} character{}", word.size(), word.size() == 1 ? "" : "s");
    return fmt::format("\"{}\"", word);
}

}  // namespace eikonal
