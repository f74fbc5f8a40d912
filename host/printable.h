#pragma once
// Text of unknown origin, made fit for a terminal.

#include <string>
#include <string_view>

namespace eikonal {

/// The text with every byte that is a control character (but line ends and tabs), or no part of a character in UTF-8, as \x1b: a file that is
/// no text must not move cursors and change colours.
std::string printable(std::string_view text);

}  // namespace eikonal
