#pragma once
// Splits pbrt files and their included files into tokens.

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

/// A token. Its text stays valid until TokenStream::forget is called.
struct Token {
    enum class Kind { word, quoted, open, close, end };
    Kind kind = Kind::end;
    std::string_view text;         ///< quoted: between the quotes, escapes resolved; end: empty
    const Source* source = nullptr;
    const char* at = nullptr;      ///< position in the source text
};

/// The beginning of a text in quotes, for messages.
std::string quote(std::string_view text);
/// A token as messages name it; a word without quotes by quoteWord().
std::string quote(const Token& token);

/// Splits a stack of texts into tokens: reads the text pushed last, and returns to the one below at its end. Errors are thrown as
/// SceneError.
class TokenStream {
public:
    TokenStream();
    ~TokenStream();
    TokenStream(const TokenStream&) = delete;
    TokenStream& operator=(const TokenStream&) = delete;

    /// Reads `text` next. `name` is its name in messages.
    void push(const std::string& name, std::string text);
    /// Whether a text of this name is being read.
    bool isOpen(const std::string& name) const;
    /// How many texts are being read: one, and the files that include each other.
    size_t depth() const { return open_.size(); }

    /// Sets a function to call at each word Include, before reading on: it may take the name of a file with nextInText() and push the
    /// file's text. Without it, Include is an ordinary word.
    void onInclude(std::function<void(const Token&)> include) { include_ = std::move(include); }

    Token next() { return take(true); }
    /// The next token, even if it is the word Include.
    Token nextInText() { return take(false); }
    /// Makes the next call return this token again.
    void putBack(const Token& token) { ahead_ = token; }

    /// Line and column of a token. Fast if the last query was near.
    SourceLocation locate(const Token& token) const;

    /// Appends numbers up to the closing bracket, and consumes it; the opening bracket was the last token. The list must end in the same
    /// text. T: float, double, int.
    template <class T> void readList(std::vector<T>& numbers);
    /// A token as a number. `wanted` completes the message "found where ... is expected".
    template <class T> T toNumber(const Token& token, const char* wanted) const;

    /// Frees the texts that were read completely; their tokens become invalid.
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
