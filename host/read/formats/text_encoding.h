#pragma once
// The encoding of text files.

#include "error.h"

#include <string_view>

namespace eikonal {

/// The text without a UTF-8 byte-order mark. Throws SceneError at `where` if it begins with the mark of UTF-16.
std::string_view withoutByteOrderMark(std::string_view text, const SourceLocation& where);

}  // namespace eikonal
