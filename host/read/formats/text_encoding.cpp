#include "read/formats/text_encoding.h"

namespace eikonal {

std::string_view withoutByteOrderMark(std::string_view text, const SourceLocation& where) {
    if (text.starts_with("\xfe\xff") || text.starts_with("\xff\xfe"))
        throw SceneError(where, "the file is UTF-16; save it as UTF-8 or ASCII");
    constexpr std::string_view utf8 = "\xef\xbb\xbf";
    if (text.starts_with(utf8)) text.remove_prefix(utf8.size());
    return text;
}

}  // namespace eikonal
