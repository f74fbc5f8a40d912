// What a terminal gets to see of a file that is no text.

#include "printable.h"

#include "unit/pbrt_reading.h"

namespace eikonal {
namespace {

using namespace std::string_literals;

TEST(Printable, KeepsText) {
    for (const std::string text : {"a.pbrt:1:2: \"b\"\n\tc", "Größe, 日本語, 😀", ""}) EXPECT_EQ(printable(text), text);
}

TEST(Printable, ShowsControlCharactersAsNumbers) {
    EXPECT_EQ(printable("\x1b[31mred\a\r\x7f"), "\\x1b[31mred\\x07\\x0d\\x7f");
    EXPECT_EQ(printable("a\0b"s), "a\\x00b");
    EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b") << "U+009B starts a sequence as ESC [ does";
}

TEST(Printable, ShowsBytesThatAreNoUtf8AsNumbers) {
    EXPECT_EQ(printable("\xff\xfe"), "\\xff\\xfe");
    EXPECT_EQ(printable("\xc3"), "\\xc3") << "cut off";
    EXPECT_EQ(printable("\xc3("), "\\xc3(");
    EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf") << "longer than it need be";
}

// However long a run of bytes without a space is, a message quotes its beginning only.
using BinaryScene = PbrtTest;
TEST_F(BinaryScene, IsQuotedInShort) {
    const std::string bytes(100'000, '\x01');
    for (const std::string& text :
         {bytes, "Shape " + bytes, "WorldBegin Shape \"sphere\" \"" + bytes + "\"", "WorldBegin Shape \"sphere\" \"float radius\" " + bytes,
          "Transform " + bytes, "WorldBegin Shape \"sphere\" \"" + bytes + " radius\" 1"})
        EXPECT_LT(errorOf(text).size(), 500u) << text.substr(0, 40);
}

}  // namespace
}  // namespace eikonal
