#pragma once
// Words of a shell's command line.

#include <string>

namespace eikonal {

/// A word as a POSIX shell reads it back, whatever is in it.
inline std::string shellWord(const std::string& word) {
    const bool isPlain =
        !word.empty() &&
        word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=./,:+%@") == std::string::npos;
    if (isPlain) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

/// Words with spaces between them.
template <class Words>
std::string shellWords(const Words& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + shellWord(word);
    return text;
}

}  // namespace eikonal
