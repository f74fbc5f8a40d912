#pragma once
// The grammar of a pbrt file: directives, one after the other.

#include "read/pbrt/builder.h"
#include "read/pbrt/tokens.h"

#include <array>
#include <string>

namespace eikonal::pbrt {

/// Reads a text's directives and carries them out on a builder. Errors in the grammar are thrown as SceneError; others are noted
/// with the builder's problems, and reading goes on.
class Parser {
public:
    /// outer: what reads the file that imports this one; null: none.
    explicit Parser(Builder& builder, const Parser* outer = nullptr);

    /// Reads a whole text, and those that it includes. Returns where it ends.
    SourceLocation read(const std::string& name, std::string text);

    // What directives are made of. Each throws SceneError if something else is there.
    double number();
    template <int count> std::array<double, count> numbers();
    Transform matrix();               ///< sixteen numbers in brackets, column after column
    std::string word();               ///< without quotes
    std::string quoted(const char* what);
    /// The string in quotes that is next, or `otherwise` if there is none.
    std::string quotedOr(const std::string& otherwise);
    /// Those without a value are refused; where an included file is missing within a list, the parameter is left out.
    ParameterList parameters();
    /// Whether the last parameters() left one out, so that what is wrong with them may be no fault of theirs.
    bool hasLostParameters() const { return hasLostParameters_; }
    SourceLocation lastPlace() const { return tokens_.locate(last_); }

    /// Reads the file that is named next, in a state of its own.
    void import(const SourceLocation& where);

private:
    Token next() { return last_ = tokens_.next(); }
    std::optional<std::pair<std::string, std::string>> openNamedFile(const SourceLocation& where, const char* directive);
    bool isReading(const std::string& path) const { return tokens_.isOpen(path) || (outer_ && outer_->isReading(path)); }

    Builder& builder_;
    const Parser* outer_;
    TokenStream tokens_;
    int missingIncludes_ = 0;
    bool hasLostParameters_ = false;
    Token last_;          ///< the last one that next() gave
};

template <int count> std::array<double, count> Parser::numbers() {
    std::array<double, count> values;
    for (double& value : values) value = number();
    return values;
}

}  // namespace eikonal::pbrt
