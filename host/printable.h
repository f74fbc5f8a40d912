#pragma once
// Makes text of unknown origin safe for a terminal.

#include <string>
#include <string_view>

namespace eikonal {

/// Replaces every byte that is a control character (except line ends and tabs) or invalid UTF-8 by its escape, such as the four characters
/// \x1b: a binary file must not move the cursor or change colours. Cuts words of more than 5000 bytes.
std::string printable(std::string_view text);

/// The same text in one line: line ends are escaped, too. A name in a scene must not begin a line, which would pass for a message.
std::string inOneLine(std::string text);

/// A word of a file in quotes, for messages, but only if it looks like a name or a number: any file that the user can read may be named as
/// part of a scene, and what is in it may be a secret. Otherwise says how long the word is.
std::string quoteWord(std::string_view word);

}  // namespace eikonal
