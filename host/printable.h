#pragma once
// Makes text of unknown origin safe for a terminal.

#include <string>
#include <string_view>

namespace eikonal {

/// Replaces every byte that is a control character (except line ends and tabs) or invalid UTF-8 by its escape, such as the four characters
/// \x1b: a binary file must not move the cursor or change colours.
std::string printable(std::string_view text);

}  // namespace eikonal
