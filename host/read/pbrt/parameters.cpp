#include "read/pbrt/parameters.h"

#include "read/pbrt/problems.h"

#include <algorithm>
#include <array>

namespace eikonal::pbrt {
namespace {

struct TypeName { const char* word; ParameterType type; };

// The words for types; messages use the first word of a type.
constexpr TypeName typeNames[] = {
    {"bool", ParameterType::boolean},     {"float", ParameterType::number},         {"integer", ParameterType::integer},
    {"point2", ParameterType::point2},    {"vector2", ParameterType::vector2},      {"point3", ParameterType::point3},
    {"vector3", ParameterType::vector3},  {"normal", ParameterType::normal},        {"rgb", ParameterType::rgb},
    {"blackbody", ParameterType::blackbody}, {"spectrum", ParameterType::spectrum}, {"string", ParameterType::text},
    {"texture", ParameterType::texture},  {"point", ParameterType::point3},         {"vector", ParameterType::vector3},
    {"normal3", ParameterType::normal},
};

ParameterType typeNamed(const std::string& word, const std::string& declaration, const SourceLocation& where) {
    for (const TypeName& type : typeNames)
        if (word == type.word) return type.type;
    if (word == "color") throw Version3Error(where, "the type of \"" + declaration + "\"", "\"rgb\"");
    if (word == "xyz") throw Version3Error(where, "the type of \"" + declaration + "\"", "\"rgb\" and \"spectrum\"");
    std::vector<std::string> words;
    for (const TypeName& type : typeNames) words.push_back(type.word);
    std::string help = nearestWord(word, words);
    help = help.empty() ? "such as float, string or rgb is expected" : "was expected; did you mean \"" + help + "\"?";
    throw SceneError(where, quote(word) + " found where the type of a parameter " + help);
}

bool isGeometric(ParameterType type) { return type >= ParameterType::point2 && type <= ParameterType::normal; }
bool isNumeric(ParameterType type) { return type != ParameterType::boolean && type < ParameterType::text; }

[[noreturn]] void throwUnexpected(const TokenStream& tokens, const Token& token, const Parameter& parameter) {
    const char* wanted = parameter.type == ParameterType::boolean ? "true or false"
                         : isNumeric(parameter.type)              ? "a number"
                                                                  : "a string in quotes";
    const std::string found = token.kind == Token::Kind::end ? "the end of the file" : quote(token);
    throw SceneError(tokens.locate(token), found + " found where \"" + parameter.declaration() + "\" has " + wanted);
}

/// A single number, or numbers in brackets.
template <class T> std::vector<T> readNumbers(TokenStream& tokens, const Token& first, const Parameter& parameter) {
    std::vector<T> numbers;
    if (first.kind == Token::Kind::open) tokens.readList(numbers);
    else if (first.kind == Token::Kind::word)
        numbers.push_back(tokens.toNumber<T>(first, parameter.type == ParameterType::integer ? "an integer" : "a number"));
    else throwUnexpected(tokens, first, parameter);
    return numbers;
}

/// Calls add(token) for each value, single or in brackets.
template <class Add> void readEach(TokenStream& tokens, const Token& first, Add&& add) {
    if (first.kind != Token::Kind::open) return add(first);
    for (Token token = tokens.next(); token.kind != Token::Kind::close; token = tokens.next()) add(token);
}

Values readValues(TokenStream& tokens, Parameter& parameter) {
    const Token first = tokens.next();
    if (parameter.type == ParameterType::integer) return readNumbers<int>(tokens, first, parameter);
    if (parameter.type == ParameterType::point3) return readNumbers<double>(tokens, first, parameter);
    if (isGeometric(parameter.type)) return readNumbers<float>(tokens, first, parameter);
    if (parameter.type == ParameterType::boolean) {
        std::vector<bool> flags;
        readEach(tokens, first, [&](const Token& token) {
            const bool isWord = token.kind == Token::Kind::word || token.kind == Token::Kind::quoted;
            if (!isWord || (token.text != "true" && token.text != "false")) throwUnexpected(tokens, token, parameter);
            flags.push_back(token.text == "true");
        });
        return flags;
    }

    // A spectrum is given by numbers or by a name: check the first value.
    bool named = !isNumeric(parameter.type);
    if (parameter.type == ParameterType::spectrum) {
        Token value = first;
        if (first.kind == Token::Kind::open) tokens.putBack(value = tokens.next());
        named = value.kind == Token::Kind::quoted;
    }
    if (!named) return readNumbers<double>(tokens, first, parameter);
    std::vector<std::string> strings;
    readEach(tokens, first, [&](const Token& token) {
        if (token.kind != Token::Kind::quoted) throwUnexpected(tokens, token, parameter);
        if (strings.empty()) {
            parameter.whereText = tokens.locate(token);
            ++parameter.whereText.column;
        }
        strings.emplace_back(token.text);
    });
    return strings;
}

}  // namespace

const char* nameOf(ParameterType type) {
    return std::ranges::find(typeNames, type, &TypeName::type)->word;
}

bool Parameter::isEmpty() const {
    return std::visit([](const auto& list) { return list.empty(); }, values);
}

std::string Parameter::declaration() const { return std::string(nameOf(type)) + " " + name; }

Parameter readParameter(TokenStream& tokens, const Token& declaration) {
    constexpr const char* blanks = " \t\r";
    const std::string_view text = declaration.text;
    Parameter parameter;
    parameter.where = tokens.locate(declaration);
    const size_t typeBegin = std::min(text.find_first_not_of(blanks), text.size());
    const size_t typeEnd = std::min(text.find_first_of(blanks, typeBegin), text.size());
    const size_t nameBegin = std::min(text.find_first_not_of(blanks, typeEnd), text.size());
    const size_t nameEnd = std::min(text.find_first_of(blanks, nameBegin), text.size());
    if (nameBegin == text.size())
        throw SceneError(parameter.where, quote(text) + " found where a parameter's type and name are expected, as in \"float radius\"");
    parameter.name = text.substr(nameBegin, nameEnd - nameBegin);
    parameter.type = typeNamed(std::string(text.substr(typeBegin, typeEnd - typeBegin)), std::string(text), parameter.where);
    parameter.values = readValues(tokens, parameter);
    return parameter;
}

}  // namespace eikonal::pbrt
