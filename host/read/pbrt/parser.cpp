#include "read/pbrt/parser.h"

#include "read/pbrt/directives.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal::pbrt {

/// Files that a scene may open by Include and Import besides two for each shape and instance, and in all, and how deep they may be nested.
/// A public Menger sponge opens 168,421 files for its 3.2 million instances.
static constexpr size_t mostIdleFiles = 100'000, mostFiles = 5'000'000, deepestNesting = 1000;

Parser::Parser(Builder& builder, const Parser* outer) : builder_(builder), outer_(outer) {
    tokens_.onInclude([this](const Token& word) {
        if (auto file = openNamedFile(tokens_.locate(word), "Include")) tokens_.push(file->first, std::move(file->second));
        else ++missingIncludes_;
    });
}

SourceLocation Parser::read(const std::string& name, std::string text) {
    tokens_.push(name, std::move(text));
    while (true) {
        tokens_.forget();
        const Token token = next();
        const SourceLocation where = tokens_.locate(token);
        if (token.kind == Token::Kind::end) return where;
        const Directive& directive = findDirective(token, where);
        if (directive.place == Place::options && builder_.inWorld)
            throw SceneError(where, std::string(directive.name) + " is only allowed before WorldBegin");
        if (directive.place == Place::world && !builder_.inWorld)
            throw SceneError(where, std::string(directive.name) + " is only allowed after WorldBegin");
        directive.run(*this, builder_, where);
    }
}

double Parser::number() { return tokens_.toNumber<double>(next(), "a number"); }

Transform Parser::matrix() {
    const auto expect = [&](Token::Kind kind, const char* what) {
        const Token token = next();
        if (token.kind != kind) throw SceneError(tokens_.locate(token), quote(token) + " found where \"" + what + "\" is expected");
        return token;
    };
    expect(Token::Kind::open, "[");
    Transform matrix;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) matrix[column][row] = number();
    const Token end = expect(Token::Kind::close, "]");
    /* Numbers 4, 8, 12 and 16 are what a point's fourth coordinate is made of */
    const auto last = [&](int column) { return matrix[column][3]; };
    constexpr double rounded = 1e-9;
    if (std::abs(last(0)) > rounded || std::abs(last(1)) > rounded || std::abs(last(2)) > rounded || last(3) == 0)
        throw SceneError(tokens_.locate(end),
                         fmt::format("the matrix is a projection: its numbers 4, 8, 12 and 16 are {:g}, {:g}, {:g} and {:g}; of matrices "
                                     "that scale, rotate, shear and move they are 0, 0, 0 and 1",
                                     last(0), last(1), last(2), last(3)));
    matrix /= last(3);
    for (int column = 0; column < 4; ++column) matrix[column][3] = column == 3;
    return matrix;
}

std::string Parser::word() {
    const Token token = next();
    if (token.kind != Token::Kind::word && token.kind != Token::Kind::quoted)
        throw SceneError(tokens_.locate(token), "a word is expected here");
    return std::string(token.text);
}

std::string Parser::quoted(const char* what) {
    const Token token = next();
    if (token.kind != Token::Kind::quoted)
        throw SceneError(tokens_.locate(token), (token.kind == Token::Kind::end ? "the file ends" : quote(token) + " found") +
                                                    " where " + what + " in quotes is expected");
    return std::string(token.text);
}

std::string Parser::quotedOr(const std::string& otherwise) {
    const Token token = next();
    if (token.kind == Token::Kind::quoted) return std::string(token.text);
    tokens_.putBack(token);
    return otherwise;
}

ParameterList Parser::parameters() {
    ParameterList list;
    hasLostParameters_ = false;
    while (true) {
        const Token token = next();
        if (token.kind != Token::Kind::quoted) {
            tokens_.putBack(token);
            return list;
        }
        const int missingBefore = missingIncludes_;
        Parameter parameter = readParameter(tokens_, token);
        if (missingIncludes_ > missingBefore) {
            hasLostParameters_ = true;
            continue;
        }
        if (parameter.isEmpty()) throw SceneError(parameter.where, "\"" + parameter.declaration() + "\" has no value");
        parameter.space = builder_.state.space;
        list.push_back(std::move(parameter));
    }
}

/// The name and text of the quoted file that comes next; nothing if it is missing, which is noted.
std::optional<std::pair<std::string, std::string>> Parser::openNamedFile(const SourceLocation& where, const char* directive) {
    const Token token = tokens_.nextInText();
    const SourceLocation place = tokens_.locate(token);
    if (token.kind != Token::Kind::quoted) throw SceneError(place, std::string(directive) + " needs the name of a file in quotes");
    const std::optional<std::string> path = builder_.reading.findFile(std::string(token.text), place);
    if (!path) return std::nullopt;
    if (isReading(*path)) throw SceneError(where, "\"" + *path + "\" includes itself");
    if (depth() > deepestNesting)
        throw SceneError(where, fmt::format("{} files are nested in each other here, and no more are read", deepestNesting));
    const size_t opened = ++builder_.reading.openedFiles, placed = builder_.shapes.placedCount();
    if (opened > std::min(mostFiles, mostIdleFiles + 2 * placed))
        throw SceneError(where, fmt::format("the scene has opened {} files for {} shapes and instances, and no more are read: a file that "
                                            "names another twice doubles their number; give repeated shapes a name with ObjectBegin",
                                            opened - 1, placed));
    return std::pair(*path, builder_.reading.includedText(*path));
}

void Parser::import(const SourceLocation& where) {
    auto file = openNamedFile(where, "Import");
    if (!file) return;
    builder_.importing([&] { Parser(builder_, this).read(file->first, std::move(file->second)); });
}

}  // namespace eikonal::pbrt
