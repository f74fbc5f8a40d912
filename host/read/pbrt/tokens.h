#pragma once
// The words of a pbrt file, and of the files that it includes.

#include "error.h"

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eikonal::pbrt {

struct Source;

/// The smallest piece of text that has a meaning. Its text stays valid until TokenStream::forget is called.
struct Token {
    enum class Kind { word, quoted, open, close, end };
    Kind kind = Kind::end;
    std::string_view text;         ///< quoted: between the quotes, escapes resolved; end: empty
    const Source* source = nullptr;
    const char* at = nullptr;      ///< in the source's text
};

/// What was found, for messages: its beginning, in quotes.
std::string quote(std::string_view text);

/// Splits a stack of texts into tokens: the one pushed last is read first, and where it ends the one below goes on.
/// Errors in the text are thrown as SceneError.
class TokenStream {
public:
    TokenStream();
    ~TokenStream();
    TokenStream(const TokenStream&) = delete;
    TokenStream& operator=(const TokenStream&) = delete;

    /// Reads `text` next. `name` is what messages call it.
    void push(const std::string& name, std::string text);
    /// Whether a text of that name is being read.
    bool isOpen(const std::string& name) const;

    /// Wherever the word Include is, `include` is called with it, and what follows is read then: `include` may take the name of a
    /// file with nextInText() and push its text. Without this, Include is a word as any other.
    void onInclude(std::function<void(const Token&)> include) { include_ = std::move(include); }

    Token next() { return take(true); }
    /// The next token, even if it is the word Include.
    Token nextInText() { return take(false); }
    /// The next token again, later.
    void putBack(const Token& token) { ahead_ = token; }

    /// Line and column of a token. Cheap if asked in the order of the text.
    SourceLocation locate(const Token& token) const;

    /// Appends the numbers up to the closing bracket and consumes it; the opening one has just been. The list ends in the text that
    /// it begins in. T: float, double, int.
    template <class T> void readList(std::vector<T>& numbers);
    /// The number that a token is. `wanted` completes "found where ... is expected".
    template <class T> T toNumber(const Token& token, const char* wanted) const;

    /// Frees the texts that have been read to their ends; tokens from them become invalid.
    void forget();

private:
    Token take(bool includes);
    Token takeText(Source& source, Token::Kind kind, const char* begin, const char* end);
    Token takeQuoted(Source& source);
    void close();

    std::vector<std::unique_ptr<Source>> open_, finished_;
    std::deque<std::string> unescaped_;
    std::optional<Token> ahead_;
    std::function<void(const Token&)> include_;
};

}  // namespace eikonal::pbrt
