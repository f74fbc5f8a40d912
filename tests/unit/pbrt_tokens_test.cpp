// How a text becomes words, strings, brackets and numbers, and where each of them is.

#include "read/pbrt/tokens.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eikonal::pbrt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Tokens : testing::Test {
    TokenStream stream;

    /// All tokens of a text: words as they are, strings with a quote before them, brackets.
    std::vector<std::string> split(const std::string& text) {
        stream.push("t", text);
        std::vector<std::string> result;
        for (Token token = stream.next(); token.kind != Token::Kind::end; token = stream.next())
            result.push_back((token.kind == Token::Kind::quoted ? "'" : "") + std::string(token.text));
        return result;
    }
    template <class T> T number(const std::string& text) {
        stream.push("t", text);
        return stream.toNumber<T>(stream.next(), "a number");
    }
    template <class T> std::vector<T> list(const std::string& text) {
        stream.push("t", text);
        EXPECT_EQ(stream.next().kind, Token::Kind::open);
        std::vector<T> numbers;
        stream.readList(numbers);
        return numbers;
    }
    template <class F> static std::string errorOf(F&& f) {
        try {
            f();
            return "no error";
        } catch (const SceneError& error) { return error.what(); }
    }
};

TEST_F(Tokens, bracketsAndQuotesEndWords) { EXPECT_THAT(split("a[1]\"b\"c"), ElementsAre("a", "[", "1", "]", "'b", "c")); }

TEST_F(Tokens, commentsEndWithTheirLine) {
    EXPECT_THAT(split("a # \"b\n c#d"), ElementsAre("a", "c#d"));  // as in pbrt-v4, a word goes on through "#"
    EXPECT_THAT(split("a # b\rc"), ElementsAre("a", "c"));
}

TEST_F(Tokens, escapesAreResolved) {
    EXPECT_THAT(split(R"("a\"b\\c\n")"), ElementsAre("'a\"b\\c\n"));
    EXPECT_THAT(errorOf([&] { split("\n \"a\\q\""); }), HasSubstr("t:2:4: \"\\q\" is not an escape"));
}

// Places are asked for in any order, and a text may be one line of megabytes.
TEST_F(Tokens, placesInAnyOrder) {
    stream.push("t", "a b\n\n  c\nd e");
    std::vector<Token> tokens;
    for (int i = 0; i < 5; ++i) tokens.push_back(stream.next());
    const auto place = [&](int i) {
        const SourceLocation where = stream.locate(tokens.at(static_cast<size_t>(i)));
        return std::pair(where.line, where.column);
    };
    const std::pair<int, int> expected[] = {{1, 1}, {1, 3}, {3, 3}, {4, 1}, {4, 3}};
    for (const int i : {4, 0, 1, 0, 3, 4, 3, 2, 4, 2, 1, 3, 0, 2}) EXPECT_EQ(place(i), expected[i]) << i;

    std::string line;
    for (int i = 0; i < 1'000'000; ++i) line += "w ";
    stream.push("t", line);
    for (int i = 0; i < 1'000'000; ++i) EXPECT_EQ(stream.locate(stream.next()).column, 2 * i + 1);
}

TEST_F(Tokens, aStringEndsOnItsLine) {
    EXPECT_THAT(errorOf([&] { split("a \"b\nc\""); }), HasSubstr("t:1:3: this string has no closing quote"));
    EXPECT_THAT(errorOf([&] { split("\"b\\"); }), HasSubstr("no closing quote"));
}

TEST_F(Tokens, placesCountFromOneInAnyOrder) {
    stream.push("t", "a\r\n  b\n\nc");
    const Token a = stream.next(), b = stream.next(), c = stream.next();
    EXPECT_EQ(stream.locate(c).toString(), "t:4:1");
    EXPECT_EQ(stream.locate(a).toString(), "t:1:1");
    EXPECT_EQ(stream.locate(b).toString(), "t:2:3");
}

TEST_F(Tokens, numbersInEveryForm) {
    EXPECT_EQ(number<double>("-.5"), -0.5);
    EXPECT_EQ(number<double>("5."), 5);
    EXPECT_EQ(number<double>("+1e3"), 1000);
    EXPECT_EQ(number<float>("1.5E-2"), 0.015f);
    EXPECT_EQ(number<float>("1e-60"), 0.f);
    EXPECT_EQ(number<int>("-2147483648"), -2147483647 - 1);
}

TEST_F(Tokens, whatIsNoNumberIsRefused) {
    for (const char* word : {"nan", "inf", "-infinity", "1x", "0x10", "--1", "+-1", "e5", "1.5.", "abc", "-"})
        EXPECT_THAT(errorOf([&] { number<double>(word); }), HasSubstr("found where a number is expected")) << word;
    EXPECT_THAT(errorOf([&] { number<int>("1.5"); }), HasSubstr("\"1.5\" found where"));
    EXPECT_THAT(errorOf([&] { number<int>("2147483648"); }), HasSubstr("too large for an integer"));
    EXPECT_THAT(errorOf([&] { number<float>("1e39"); }), HasSubstr("too large"));
}

TEST_F(Tokens, listsOfNumbers) {
    EXPECT_THAT(list<float>("[1 # one\n 2.5\t+3]"), ElementsAre(1.f, 2.5f, 3.f));
    EXPECT_THAT(list<int>("[]"), ElementsAre());
    EXPECT_THAT(errorOf([&] { list<int>("[1\n 2.5]"); }), HasSubstr("t:2:2: \"2.5\" found where an integer is expected"));
    EXPECT_THAT(errorOf([&] { list<float>("[1 \"2\"]"); }), HasSubstr("t:1:4: \"2\" found where a number is expected"));
    EXPECT_THAT(errorOf([&] { list<float>("[1 [2]]"); }), HasSubstr("\"[\" found where a number is expected"));
}

TEST_F(Tokens, aListEndsInTheTextThatItBeginsIn) {
    stream.push("outer", "]");
    EXPECT_THAT(errorOf([&] { list<float>("[1 2"); }), HasSubstr("t:1:5: the file ends within a list of numbers"));
}

TEST_F(Tokens, textsAreReadOneInsideTheOther) {
    stream.push("outer", "a Include b");
    stream.onInclude([&](const Token&) { stream.push("inner", "x y"); });
    std::vector<std::string> places;
    for (Token token = stream.next(); token.kind != Token::Kind::end; token = stream.next())
        places.push_back(std::string(token.text) + " " + stream.locate(token).toString());
    EXPECT_THAT(places, ElementsAre("a outer:1:1", "x inner:1:1", "y inner:1:3", "b outer:1:11"));
}

TEST_F(Tokens, includeWorksInsideOfLists) {
    stream.onInclude([&](const Token&) { stream.push("inner", stream.nextInText().text == "two" ? "3 4 Include three" : " # empty"); });
    EXPECT_THAT(list<int>("[1 2 Include two 5]"), ElementsAre(1, 2, 3, 4, 5));
    EXPECT_THAT(list<int>("[Include three]"), ElementsAre());
    EXPECT_THAT(errorOf([&] { list<int>("[1 Include two"); }), HasSubstr("the file ends within a list of numbers"));
}

TEST_F(Tokens, whatIsPutBackOutlivesItsText) {
    stream.push("t", "a");
    stream.next();
    const Token end = stream.next();
    stream.putBack(end);
    stream.forget();
    EXPECT_EQ(stream.locate(stream.next()).toString(), "t:1:2");
}

}  // namespace
}  // namespace eikonal::pbrt
