#pragma once
// How options are declared: once each, with the help text and the check of the range.

#include "app/option_values.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace eikonal {

inline constexpr int unlimited = std::numeric_limits<int>::max();
/// Groups of --help that several files name.
inline constexpr const char *sceneGroup = "Scene (overrides the file)", *objGroup = "Camera of an OBJ", *deviceGroup = "Device",
                            *framesGroup = "Frames", *imageGroup = "Image", *partsGroup = "Checkpoints and parts";
/// The type of values that may be empty.
inline constexpr const char* freeText = "TEXT";
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Lets completion offer `words`, which are kept as the name of a validator that accepts everything.
inline CLI::Option* offer(CLI::Option* option, const std::vector<std::string>& words) {
    CLI::Validator keeper([](std::string&) { return std::string(); }, "");
    return option->check(keeper.name(fmt::format("{}", fmt::join(words, " "))));
}

/// Declares an option whose value is read by `parse(option, text)`.
template <class Target, class Parse>
CLI::Option* value(CLI::App* app, const std::string& names, Target& target, const std::string& type, const std::string& help, Parse parse) {
    const std::string option = names.substr(names.rfind("--"));
    CLI::Option* declared = app->add_option_function<std::string>(
        names, [&target, option, parse](const std::string& text) { target = parse(option, text); }, help);
    if constexpr (requires { parse.words(); }) offer(declared, parse.words());
    return declared->type_name(type);
}

/// Parsers of values, for `value`: numbers within a range, and one of some names.
inline auto integer(int low, int high = unlimited) {
    return [=](const std::string& option, const std::string& text) { return parseInteger(option, text, low, high); };
}
inline auto number(double low, double high = infinity) {
    return [=](const std::string& option, const std::string& text) { return parseNumber(option, text, low, high); };
}
inline auto numberFrom(double low, double high = infinity) {
    return [=](const std::string& option, const std::string& text) { return parseNumberFrom(option, text, low, high); };
}
template <class Value>
struct OneOf {
    std::vector<std::pair<const char*, Value>> names;
    Value operator()(const std::string& option, const std::string& text) const { return parseName(option, text, names); }
    std::vector<std::string> words() const {
        std::vector<std::string> all;
        for (const auto& [name, value] : names) all.emplace_back(name);
        return all;
    }
};
template <class Value>
OneOf<Value> oneOf(std::vector<std::pair<const char*, Value>> names) {
    return {std::move(names)};
}

}  // namespace eikonal
