#pragma once
// The lines of an OBJ or MTL file, as words.

#include "error.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace eikonal {

/// Goes through a text line by line. Lines end with \n, \r\n or \r; a backslash at the end of a line joins the next one to it.
class ObjLines {
public:
    /// The text must outlive this and all words. A byte-order mark is skipped. Throws SceneError at a byte 0: that is no text.
    ObjLines(std::string_view text, std::shared_ptr<const std::string> file);

    /// Goes to the next line that has a word; false at the end. A line's comment (a word that begins with #) is no part of it.
    bool next();

    const std::vector<std::string_view>& words() const { return words_; }
    /// From word i to the end of the line, without white space around it and with its comment, if there is one: names may have spaces, and #.
    std::string rest(std::size_t i) const;

    SourceLocation where() const { return {file_, line_, 0}; }
    /// The place of word i. Columns in joined lines count from the beginning of the first.
    SourceLocation where(std::size_t i) const;
    int line() const { return line_; }

    /// Word i as a number. Throws SceneError if it is none, or not finite.
    double number(std::size_t i) const;

private:
    std::string_view text_, current_;
    std::string joined_;
    std::shared_ptr<const std::string> file_;
    std::size_t at_ = 0;
    int line_ = 0, linesTaken_ = 0;
    std::vector<std::string_view> words_;
};

/// The whole of a word as a number; false if it is none, or none that is finite in single precision: NaN, infinity, 1e300.
bool parseNumber(std::string_view word, double& value);

}  // namespace eikonal
