// What a terminal gets to see of a file that is no text.

#include "printable.h"

#include "unit/pbrt_reading.h"

#include <gmock/gmock.h>

namespace eikonal {
namespace {

using namespace std::string_literals;

TEST(Printable, CutsWordsThatAreNone) {
    const std::string path(4096, 'p'), junk(3'000'000, 'x');
    EXPECT_EQ(printable("there is no " + path + " here"), "there is no " + path + " here");
    EXPECT_EQ(printable("no \"" + junk + "\" here"), "no \"" + junk.substr(0, 4999) + "... (and 2995002 more characters) here");
}

TEST(Printable, KeepsText) {
    for (const std::string text : {"a.pbrt:1:2: \"b\"\n\tc", "Größe, 日本語, 😀", ""}) EXPECT_EQ(printable(text), text);
}

TEST(Printable, ShowsControlCharactersAsNumbers) {
    EXPECT_EQ(printable("\x1b[31mred\a\r\x7f"), "\\x1b[31mred\\x07\\x0d\\x7f");
    EXPECT_EQ(printable("a\0b"s), "a\\x00b");
    EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b") << "U+009B starts a sequence as ESC [ does";
}

TEST(Printable, MakesOneLine) { EXPECT_EQ(inOneLine("a\nb\n"), "a\\x0ab\\x0a"); }

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

TEST(Printable, QuotesNamesAndNumbersOnly) {
    for (const std::string word : {"Shpae", "-1.5e+20", "1,0", "glass-F11", "a_b"}) EXPECT_EQ(quoteWord(word), '"' + word + '"');
    EXPECT_EQ(quoteWord("root:$y$j9T$Ab:19700:0:99999:7:::"), "a word of 33 characters");
    EXPECT_EQ(quoteWord(std::string(41, 'a')), "a word of 41 characters");
    EXPECT_EQ(quoteWord("\x1b[31m"), "a word of 5 characters");
}

/// Whoever may write a scene may name any file in it that whoever renders it can read, and may see the messages.
using OtherFile = PbrtTest;
TEST_F(OtherFile, IsNotQuoted) {
    const std::string secret = "root:$y$j9T$Ab:19700:0:99999:7:::";
    write("shadow", secret + "\ndaemon:*:19000\n");
    const std::string camera = "Camera \"realistic\" \"string lensfile\" \"shadow\"\nWorldBegin\n";
    for (const std::string& text : {camera, std::string("Include \"shadow\""), std::string("WorldBegin Import \"shadow\""),
                                    std::string("WorldBegin Material \"conductor\" \"spectrum eta\" \"shadow\"")}) {
        const std::string error = errorOf(text);
        EXPECT_THAT(error, testing::HasSubstr("shadow:1:1: a word of 33 characters found where a ")) << text;
        EXPECT_THAT(error, testing::Not(testing::HasSubstr("19700"))) << text;
    }
}

}  // namespace
}  // namespace eikonal
