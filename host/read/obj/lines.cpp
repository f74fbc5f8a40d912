#include "read/obj/lines.h"

#include "printable.h"
#include "read/formats/text_encoding.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace eikonal {
namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

/// Parses a whole word; the error is result_out_of_range for numbers that are too large or too small for doubles.
std::errc parseDouble(std::string_view word, double& value) {
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return stop == word.data() + word.size() ? error : std::errc::invalid_argument;
}

bool isTooLarge(std::string_view word) {
    double value = 0;
    const std::errc error = parseDouble(word, value);
    if (error == std::errc::result_out_of_range) return std::isinf(std::strtod(std::string(word).c_str(), nullptr));
    return error == std::errc{} && std::isfinite(value) && std::abs(value) > std::numeric_limits<float>::max();
}

}  // namespace

bool parseNumber(std::string_view word, double& value) {
    return parseDouble(word, value) == std::errc{} && std::abs(value) <= std::numeric_limits<float>::max();
}

std::string numberProblem(std::string_view word) {
    return quoteWord(word) + (isTooLarge(word) ? " is too large: single precision ends at about 3.4e38" : " is not a finite number");
}

ObjLines::ObjLines(std::string_view text, std::shared_ptr<const std::string> file)
    : text_(withoutByteOrderMark(text, {file, 1, 0})), file_(std::move(file)) {
    const std::size_t zero = text_.find('\0');
    if (zero == text_.npos) return;
    const std::string_view before = text_.substr(0, zero);
    const std::size_t lineBegin = before.rfind('\n') + 1;  // 0 in the first line, where rfind finds none
    throw SceneError({file_, static_cast<int>(std::ranges::count(before, '\n')) + 1, static_cast<int>(zero - lineBegin) + 1},
                     "a byte is zero: this is not a text file");
}

SourceLocation ObjLines::whereBefore(int line, std::size_t i) {
    at_ = 0;
    line_ = linesTaken_ = 0;
    while (line_ != line && next()) {}
    return where(i);
}

bool ObjLines::next() {
    const auto takeLine = [&] {
        const std::size_t end = std::min(text_.find_first_of("\n\r", at_), text_.size());
        const std::string_view line = text_.substr(at_, end - at_);
        at_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
        ++linesTaken_;
        return line;
    };
    while (at_ < text_.size()) {
        line_ = linesTaken_ + 1;
        current_ = takeLine();
        if (current_.ends_with('\\')) {
            joined_.clear();
            while (current_.ends_with('\\')) {
                joined_ += current_.substr(0, current_.size() - 1);
                joined_ += ' ';
                current_ = at_ < text_.size() ? takeLine() : std::string_view{};
            }
            joined_ += current_;
            current_ = joined_;
        }

        words_.clear();
        for (std::size_t i = 0; i < current_.size();) {
            if (isSpace(current_[i])) { ++i; continue; }
            if (current_[i] == '#') break;
            const std::size_t begin = i;
            while (i < current_.size() && !isSpace(current_[i])) ++i;
            words_.push_back(current_.substr(begin, i - begin));
        }
        if (!words_.empty()) return true;
    }
    return false;
}

std::string ObjLines::rest(std::size_t i) const {
    if (i >= words_.size()) return {};
    std::string_view result = current_.substr(static_cast<std::size_t>(words_[i].data() - current_.data()));
    while (!result.empty() && isSpace(result.back())) result.remove_suffix(1);
    return std::string(result);
}

SourceLocation ObjLines::where(std::size_t i) const {
    return {file_, line_, i < words_.size() ? static_cast<int>(words_[i].data() - current_.data()) + 1 : 0};
}

double ObjLines::number(std::size_t i) const {
    double value = 0;
    if (i >= words_.size()) throw SceneError(where(), fmt::format("\"{}\" needs {} numbers, and has {}", words_[0], i, words_.size() - 1));
    if (!parseNumber(words_[i], value)) throw SceneError(where(i), numberProblem(words_[i]));
    return value;
}

}  // namespace eikonal
