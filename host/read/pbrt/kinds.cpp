#include "read/pbrt/kinds.h"

#include "read/pbrt/problems.h"
#include "read/pbrt/version3.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace eikonal::pbrt {
namespace {

using T = ParameterType;

struct Word {
    const char* word;
    Wanted wanted;
    std::vector<ParameterType> types;
};

// The words for types in rows, in the order of Wanted.
const std::vector<Word>& words() {
    static const std::vector<Word> all = {
        {"bool", Wanted::flag, {T::boolean}},
        {"float", Wanted::number, {T::number}},
        {"floats", Wanted::numbers, {T::number}},
        {"integer", Wanted::integer, {T::integer}},
        {"integers", Wanted::integers, {T::integer}},
        {"string", Wanted::text, {T::text}},
        {"strings", Wanted::texts, {T::text}},
        {"file", Wanted::file, {T::text}},
        {"point2s", Wanted::point2s, {T::point2}},
        {"point3", Wanted::point3, {T::point3}},
        {"point3s", Wanted::point3s, {T::point3}},
        {"vector3", Wanted::vector3, {T::vector3}},
        {"vector3s", Wanted::vector3s, {T::vector3}},
        {"normals", Wanted::normals, {T::normal}},
        {"floatmap", Wanted::floatMap, {T::number, T::texture}},
        {"colormap", Wanted::colorMap, {T::rgb, T::spectrum, T::blackbody, T::texture}},
        {"spectrummap", Wanted::spectrumMap, {T::rgb, T::spectrum, T::blackbody, T::texture}},
        {"spectrum", Wanted::spectrum, {T::rgb, T::spectrum, T::blackbody}},
        {"colors", Wanted::colors, {T::rgb}},
        {"index", Wanted::index, {T::number, T::rgb, T::spectrum, T::blackbody}},
        {"floattexture", Wanted::floatTexture, {T::texture}},
    };
    return all;
}

const Word& wordOf(Wanted wanted) { return words()[static_cast<size_t>(wanted)]; }

std::string trimmed(std::string_view text) {
    const size_t begin = std::min(text.find_first_not_of(" \n"), text.size());
    const size_t end = text.find_last_not_of(" \n") + 1;
    return std::string(text.substr(begin, std::max(end, begin) - begin));
}

/// Splits `text` at `separator`, keeps the front in `text`, and returns the rest; nothing if there is no separator.
std::string cutAt(std::string& text, std::string_view separator) {
    const size_t at = text.find(separator);
    if (at == text.npos) return {};
    const std::string rest = trimmed(std::string_view(text).substr(at + separator.size()));
    text = trimmed(std::string_view(text).substr(0, at));
    return rest;
}

/// "(0, 180]", "[0, inf)": round brackets exclude the end.
Range parseRange(const std::string& text, bool clamps) {
    const size_t comma = text.find(',');
    if (text.size() < 5 || comma == text.npos) throw std::logic_error("not a range: " + text);
    const Range range{std::stod(text.substr(1)), std::stod(text.substr(comma + 1)), text.front() == '[', text.back() == ']', clamps, text};
    if (clamps && ((std::isfinite(range.low) && !range.holdsLow) || (std::isfinite(range.high) && !range.holdsHigh)))
        throw std::logic_error("there is no end to clamp to: " + text);
    return range;
}

/// "{flat, ribbon}"
std::vector<std::string> parseChoices(const std::string& text) {
    if (!text.ends_with('}')) throw std::logic_error("not a list of words: " + text);
    std::vector<std::string> choices;
    for (std::string rest = text.substr(1, text.size() - 2); !rest.empty();) {
        const std::string after = cutAt(rest, ",");
        choices.push_back(std::exchange(rest, after));
    }
    return choices;
}

Rule parseRule(std::string text) {
    Rule rule;
    rule.as = cutAt(text, "->");
    const std::string clamped = cutAt(text, " clamped to "), within = cutAt(text, " in ");
    if (!clamped.empty()) rule.range = parseRange(clamped, true);
    if (within.starts_with('{')) rule.choices = parseChoices(within);
    else if (!within.empty()) rule.range = parseRange(within, false);
    rule.fallback = cutAt(text, "=");
    rule.orElse = cutAt(text, "|");
    rule.name = cutAt(text, " ");
    const auto word = std::ranges::find_if(words(), [&](const Word& w) { return text == w.word; });
    if (word == words().end() || rule.name.empty()) throw std::logic_error("not a rule for a parameter: " + text);
    rule.wanted = word->wanted;
    if (rule.as.empty()) rule.as = rule.name;
    return rule;
}

void parseRules(std::string_view text, std::vector<Rule>& rules) {
    while (!text.empty()) {
        const size_t end = std::min(text.find(';'), text.size());
        const std::string rule = trimmed(text.substr(0, end));
        if (!rule.empty()) rules.push_back(parseRule(rule));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

}  // namespace

const Rule* Kind::rule(const std::string& parameter) const {
    const auto found = std::ranges::find(rules, parameter, &Rule::name);
    return found == rules.end() ? nullptr : &*found;
}

const Rule* Kind::ruleFor(const Parameter& parameter) const {
    const auto found = std::ranges::find_if(rules, [&](const Rule& rule) {
        return rule.hasName(parameter.name) && accepts(rule, parameter.type);
    });
    return found == rules.end() ? nullptr : &*found;
}

std::vector<std::string> Kind::parameters() const {
    std::vector<std::string> names;
    for (const Rule& rule : rules)
        for (const std::string& parameter : {rule.name, rule.orElse})
            if (!parameter.empty() && std::ranges::find(names, parameter) == names.end()) names.push_back(parameter);
    return names;
}

KindTable::KindTable(const char* noun, const char* common, const std::vector<Row>& rows) : noun_(noun) {
    for (const Row& row : rows) {
        if (!row.name) continue;
        Kind kind{noun, row.name, row.value, {}, row.standIn};
        parseRules(row.parameters, kind.rules);
        parseRules(common, kind.rules);
        kinds_.push_back(std::move(kind));
    }
}

const Kind& KindTable::find(const std::string& name, const SourceLocation& where) const {
    for (const Kind& kind : kinds_)
        if (kind.name == name) return kind;
    if (const auto successor = successorOf(noun_, name)) throw Version3Error(where, noun_ + " \"" + name + "\"", successor->c_str());
    std::vector<std::string> names;
    for (const Kind& kind : kinds_) names.push_back(kind.name);
    const std::string near = nearestWord(name, names);
    throw SceneError(where, "there is no " + noun_ + " \"" + name + "\"" +
                                (near.empty() ? ": it can be " + alternatives(names) : "; did you mean \"" + near + "\"?"));
}

std::string alternatives(const std::vector<std::string>& items) {
    std::string text;
    for (size_t i = 0; i < items.size(); ++i) text += (i == 0 ? "\"" : i + 1 == items.size() ? " or \"" : ", \"") + items[i] + '"';
    return text;
}

bool accepts(const Rule& rule, ParameterType type) {
    return std::ranges::find(wordOf(rule.wanted).types, type) != wordOf(rule.wanted).types.end();
}

std::string acceptedDeclarations(const Rule& rule, const std::string& name) {
    std::vector<std::string> declarations;
    for (ParameterType type : wordOf(rule.wanted).types) declarations.push_back(std::string(nameOf(type)) + " " + name);
    return alternatives(declarations);
}

}  // namespace eikonal::pbrt
