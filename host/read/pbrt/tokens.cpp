#include "read/pbrt/tokens.h"

#include "printable.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <type_traits>
#include <utility>

namespace eikonal::pbrt {

/// An open text.
struct Source {
    std::shared_ptr<const std::string> name;
    std::filesystem::path path;  ///< the name, lexically normal
    std::string text;
    const char* at = nullptr;    ///< next character
    const char* end = nullptr;

    // Position of the last query, its line and where that begins: a query counts only from there, since a text may be one long line.
    mutable const char* counted = nullptr;
    mutable const char* lineBegin = nullptr;
    mutable int line = 1;
};

std::string quote(std::string_view text) { return '"' + std::string(text.substr(0, 60)) + (text.size() > 60 ? "..." : "") + '"'; }

std::string quote(const Token& token) { return token.kind == Token::Kind::word ? quoteWord(token.text) : quote(token.text); }

namespace {

bool isSpace(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }
bool endsWord(char c) { return isSpace(c) || c == '"' || c == '[' || c == ']'; }

const char* skipSpaceAndComments(const char* at, const char* end) {
    while (at != end) {
        if (isSpace(*at)) {
            ++at;
        } else if (*at == '#') {
            at = std::find_if(at, end, [](char c) { return c == '\n' || c == '\r'; });
        } else {
            break;
        }
    }
    return at;
}

const char* endOfWord(const char* at, const char* end) { return std::find_if(at, end, endsWord); }

/// The word for a number type in messages.
template <class T> constexpr const char* numberWord = std::is_integral_v<T> ? "an integer" : "a number";

/// Parses a number that the fast path refused: with a plus sign, out of range, or not a number.
template <class T> T toUnusualNumber(std::string_view word, const char* wanted, const SourceLocation& where) {
    std::string_view digits = word;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const char* end = digits.data() + digits.size();
    double value = 0;
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    const bool isNumber = !digits.empty() && (std::isdigit(static_cast<unsigned char>(digits.back())) || digits.back() == '.') &&
                          !(word.starts_with('+') && digits.starts_with('-')) && stop == end;
    if (!isNumber) throw SceneError(where, quoteWord(word) + " found where " + wanted + " is expected");
    if constexpr (std::is_integral_v<T>) {
        T integer = 0;
        const auto [integerStop, integerError] = std::from_chars(digits.data(), end, integer);
        if (integerStop != end) throw SceneError(where, quoteWord(word) + " found where " + wanted + " is expected");
        if (integerError != std::errc()) throw SceneError(where, quoteWord(word) + " is too large for an integer of 32 bits");
        return integer;
    } else {
        // Underflow counts as zero.
        const bool tiny = error == std::errc::result_out_of_range && digits.find_first_of("eE") != digits.npos &&
                          digits.find('-', digits.find_first_of("eE")) != digits.npos;
        if (tiny) return 0;
        if (error != std::errc() || std::abs(value) > std::numeric_limits<T>::max())
            throw SceneError(where, quoteWord(word) + " is too large for a floating-point number");
        return static_cast<T>(value);
    }
}

/// Parses a number in the usual form; returns null for other forms.
template <class T> const char* readUsualNumber(const char* at, const char* end, T& value) {
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error != std::errc() || (stop != end && !endsWord(*stop))) return nullptr;
    if constexpr (std::is_floating_point_v<T>)
        if (!std::isfinite(value)) return nullptr;  // "inf" and "nan" are not numbers here
    return stop;
}

}  // namespace

TokenStream::TokenStream() = default;
TokenStream::~TokenStream() = default;

void TokenStream::push(const std::string& name, std::string text) {
    auto source = std::make_unique<Source>();
    source->name = std::make_shared<const std::string>(name);
    source->path = std::filesystem::path(name).lexically_normal();
    source->text = std::move(text);
    source->at = source->counted = source->lineBegin = source->text.data();
    source->end = source->at + source->text.size();
    open_.push_back(std::move(source));
}

/// Closes a text that was read completely.
void TokenStream::close() {
    finished_.push_back(std::move(open_.back()));
    open_.pop_back();
}

void TokenStream::forget() {
    std::erase_if(finished_, [&](const auto& source) { return !ahead_ || ahead_->source != source.get(); });
    if (!ahead_) unescaped_.clear();
}

bool TokenStream::isOpen(const std::string& name) const {
    const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
    return std::ranges::any_of(open_, [&](const auto& source) { return source->path == path; });
}

SourceLocation TokenStream::locate(const Token& token) const {
    if (!token.source) return {};
    const Source& source = *token.source;
    const auto beginOfLine = [&](const char* from) {
        const void* newline = memrchr(from, '\n', token.at - from);
        return newline ? static_cast<const char*>(newline) + 1 : nullptr;
    };
    if (token.at >= source.counted) {
        source.line += static_cast<int>(std::count(source.counted, token.at, '\n'));
        if (const char* begin = beginOfLine(source.counted)) source.lineBegin = begin;
    } else if (token.at < source.lineBegin) {
        source.line -= static_cast<int>(std::count(token.at, source.lineBegin, '\n'));
        const char* begin = beginOfLine(source.text.data());
        source.lineBegin = begin ? begin : source.text.data();
    }
    source.counted = token.at;
    return {source.name, source.line, static_cast<int>(token.at - source.lineBegin) + 1};
}

Token TokenStream::takeText(Source& source, Token::Kind kind, const char* begin, const char* end) {
    source.at = end;
    return {kind, {begin, static_cast<size_t>(end - begin)}, &source, begin};
}

Token TokenStream::take(bool includes) {
    if (ahead_) return *std::exchange(ahead_, std::nullopt);
    Token end;
    while (!open_.empty()) {
        Source& source = *open_.back();
        source.at = skipSpaceAndComments(source.at, source.end);
        if (source.at == source.end) {
            end = {Token::Kind::end, {}, &source, source.at};
            close();
            continue;
        }
        switch (*source.at) {
            case '[': return takeText(source, Token::Kind::open, source.at, source.at + 1);
            case ']': return takeText(source, Token::Kind::close, source.at, source.at + 1);
            case '"': return takeQuoted(source);
            default: {
                const Token word = takeText(source, Token::Kind::word, source.at, endOfWord(source.at, source.end));
                if (!includes || !include_ || word.text != "Include") return word;
                include_(word);
            }
        }
    }
    return end;
}

Token TokenStream::takeQuoted(Source& source) {
    const char* begin = source.at + 1;
    const char* at = begin;
    bool escaped = false;
    while (at != source.end && *at != '"' && *at != '\n') {
        escaped |= *at == '\\';
        at += *at == '\\' && at + 1 != source.end && at[1] != '\n' ? 2 : 1;
    }
    Token token{Token::Kind::quoted, {begin, static_cast<size_t>(at - begin)}, &source, source.at};
    if (at == source.end || *at == '\n') throw SceneError(locate(token), "this string has no closing quote on its line");
    source.at = at + 1;
    if (!escaped) return token;

    // Resolve the escapes.
    std::string& text = unescaped_.emplace_back();
    for (const char* c = begin; c != at; ++c) {
        if (*c != '\\') {
            text += *c;
            continue;
        }
        constexpr std::string_view letters = "bfnrt\\'\"", meanings = "\b\f\n\r\t\\'\"";
        const size_t which = letters.find(*++c);
        if (which == letters.npos)
            throw SceneError(locate({Token::Kind::word, {}, &source, c - 1}),
                             std::string("\"\\") + *c + "\" is not an escape: \\b \\f \\n \\r \\t \\\\ \\' and \\\" are");
        text += meanings[which];
    }
    token.text = text;
    return token;
}

template <class T> T TokenStream::toNumber(const Token& token, const char* wanted) const {
    T value = 0;
    const char* end = token.text.data() + token.text.size();
    if (token.kind == Token::Kind::word && readUsualNumber(token.text.data(), end, value)) return value;
    if (token.kind == Token::Kind::end) throw SceneError(locate(token), std::string("the file ends where ") + wanted + " is expected");
    if (token.kind != Token::Kind::word) throw SceneError(locate(token), quote(token) + " found where " + wanted + " is expected");
    return toUnusualNumber<T>(token.text, wanted, locate(token));
}

template <class T> void TokenStream::readList(std::vector<T>& numbers) {
    if (ahead_ && ahead_->kind != Token::Kind::end) open_.back()->at = std::exchange(ahead_, std::nullopt)->at;
    const size_t depth = open_.size();
    while (!ahead_) {
        // Read numbers as long as they have the usual form.
        Source& source = *open_.back();
        const char* const end = source.end;
        const char* at = skipSpaceAndComments(source.at, end);
        T value;
        for (const char* stop; at != end && (stop = readUsualNumber(at, end, value)); at = skipSpaceAndComments(stop, end))
            numbers.push_back(value);
        source.at = at;

        // Next is the end of the text, the end of the list, or an unusual number.
        if (at == end) {
            if (open_.size() <= depth) break;
            close();
            continue;
        }
        const Token token = next();
        if (token.kind == Token::Kind::close) return;
        if (token.kind == Token::Kind::end) putBack(token);
        else numbers.push_back(toNumber<T>(token, numberWord<T>));
    }
    const Token end = ahead_ ? *ahead_ : Token{Token::Kind::end, {}, open_.back().get(), open_.back()->end};
    throw SceneError(locate(end), "the file ends within a list of numbers");
}

template void TokenStream::readList(std::vector<float>&);
template void TokenStream::readList(std::vector<double>&);
template void TokenStream::readList(std::vector<int>&);
template int TokenStream::toNumber(const Token&, const char*) const;
template double TokenStream::toNumber(const Token&, const char*) const;
template float TokenStream::toNumber(const Token&, const char*) const;

}  // namespace eikonal::pbrt
