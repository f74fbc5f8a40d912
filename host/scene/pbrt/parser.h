#pragma once
// The grammar of a pbrt file: directives, one after the other.

#include "scene/pbrt/builder.h"
#include "scene/pbrt/tokens.h"

#include <array>
#include <string>

namespace eikonal::pbrt {

/// Reads a text's directives and carries them out on a builder. Errors in the grammar are thrown as SceneError; others are noted
/// with the builder's problems, and reading goes on.
class Parser {
public:
    Parser(Builder& builder) : builder_(builder) {}

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
    ParameterList parameters();
    SourceLocation lastPlace() const { return tokens_.locate(last_); }

    void include(const SourceLocation& where);
    void import(const SourceLocation& where);

private:
    Token next();
    std::optional<std::pair<std::string, std::string>> openNamedFile(const SourceLocation& where, const char* directive);

    Builder& builder_;
    TokenStream tokens_;
    Token last_;          ///< the last one that next() gave
};

template <int count> std::array<double, count> Parser::numbers() {
    std::array<double, count> values;
    for (double& value : values) value = number();
    return values;
}

}  // namespace eikonal::pbrt
