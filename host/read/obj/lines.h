#pragma once
// Splits an OBJ or MTL file into lines and words.

#include "error.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace eikonal {

/// Iterates over the lines of a text. Lines end with \n, \r\n or \r; a backslash at the end of a line joins the next line to it.
class ObjLines {
public:
    /// The text must outlive this object and all words. Skips a byte-order mark. Throws SceneError for UTF-16, and at a zero byte,
    /// since that is not text.
    ObjLines(std::string_view text, std::shared_ptr<const std::string> file);

    /// Goes to the next line with a word; returns false at the end. Comments (from a word that begins with #) are skipped.
    bool next();

    const std::vector<std::string_view>& words() const { return words_; }
    /// The text from word i to the end of the line, trimmed, including a comment, because names may contain spaces and #.
    std::string rest(std::size_t i) const;

    /// The place of word i. In joined lines, columns count from the beginning of the first line.
    SourceLocation where(std::size_t i = 0) const;
    /// The place of word i of a line that next() has gone to before. Goes there.
    SourceLocation whereBefore(int line, std::size_t i);
    int line() const { return line_; }

    /// Word i as a number. Throws SceneError if it is not a finite number.
    double number(std::size_t i) const;

private:
    std::string_view text_, current_;
    std::string joined_;
    std::shared_ptr<const std::string> file_;
    std::size_t at_ = 0;
    int line_ = 0, linesTaken_ = 0;
    std::vector<std::string_view> words_;
};

/// Parses a whole word as a number; false if it is not one, or is not finite in single precision: NaN, infinity, 1e300.
bool parseNumber(std::string_view word, double& value);
/// What is wrong with a word that parseNumber refuses, as a message.
std::string numberProblem(std::string_view word);

}  // namespace eikonal
