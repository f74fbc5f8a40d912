#pragma once
// The grammar of pbrt files: a sequence of directives.

#include "read/pbrt/builder.h"
#include "read/pbrt/tokens.h"

#include <array>
#include <string>

namespace eikonal::pbrt {

/// Reads the directives of a text and applies them to a builder. Grammar errors are thrown as SceneError; other errors are noted with the
/// builder's problems, and reading continues.
class Parser {
public:
    /// outer: the parser of the importing file; null if there is none.
    explicit Parser(Builder& builder, const Parser* outer = nullptr);

    /// Reads a whole text and the files that it includes. Returns the place of its end.
    SourceLocation read(const std::string& name, std::string text);

    // The parts of directives. Each throws SceneError if something else is found.
    double number();
    template <int count> std::array<double, count> numbers();
    Transform matrix();               ///< sixteen numbers in brackets, column after column
    std::string word();               ///< without quotes
    std::string quoted(const char* what);
    /// The quoted string that comes next; `otherwise` if none does.
    std::string quotedOr(const std::string& otherwise);
    /// Refuses parameters without a value. If an included file is missing within a list, the parameter is dropped.
    ParameterList parameters();
    /// Whether the last parameters() dropped one, so that further errors may be consequences.
    bool hasLostParameters() const { return hasLostParameters_; }
    SourceLocation lastPlace() const { return tokens_.locate(last_); }

    /// Reads the file named next, with a state of its own.
    void import(const SourceLocation& where);

private:
    Token next() { return last_ = tokens_.next(); }
    std::optional<std::pair<std::string, std::string>> openNamedFile(const SourceLocation& where, const char* directive);
    size_t depth() const { return tokens_.depth() + (outer_ ? outer_->depth() : 0); }
    bool isReading(const std::string& path) const { return tokens_.isOpen(path) || (outer_ && outer_->isReading(path)); }

    Builder& builder_;
    const Parser* outer_;
    TokenStream tokens_;
    int missingIncludes_ = 0;
    bool hasLostParameters_ = false;
    Token last_;          ///< the last result of next()
};

template <int count> std::array<double, count> Parser::numbers() {
    std::array<double, count> values;
    for (double& value : values) value = number();
    return values;
}

}  // namespace eikonal::pbrt
