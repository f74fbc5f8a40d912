#include "read/obj/mtl.h"

#include "printable.h"
#include "read/obj/lines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <ranges>

namespace eikonal {
namespace {

/// A texture option. It takes `least` to `most` words; words beyond `least` must be numbers.
struct Option { std::string_view name; std::size_t least, most; };
constexpr std::array<Option, 14> options{{{"-s", 1, 3},
                                          {"-o", 1, 3},
                                          {"-t", 1, 3},
                                          {"-mm", 2, 2},
                                          {"-bm", 1, 1},
                                          {"-clamp", 1, 1},
                                          {"-blendu", 1, 1},
                                          {"-blendv", 1, 1},
                                          {"-boost", 1, 1},
                                          {"-texres", 1, 1},
                                          {"-imfchan", 1, 1},
                                          {"-type", 1, 1},
                                          {"-colorspace", 1, 1},
                                          {"-cc", 1, 1}}};

std::string lower(std::string_view word) {
    std::string result(word);
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::tolower(c); });
    return result;
}

/// Word i of a statement as a number.
double numberIn(const MtlMaterial::Statement& statement, std::size_t i) {
    double value = 0;
    if (!parseNumber(statement.words[i], value))
        throw SceneError(statement.places[i], numberProblem(statement.words[i]));
    return value;
}

/// Applies an option whose values are the words from number `first` on.
void applyOption(MtlTexture& texture, const MtlMaterial::Statement& statement, std::string_view name, std::size_t first,
                 std::size_t count) {
    const std::vector<std::string> values(statement.words.begin() + static_cast<std::ptrdiff_t>(first),
                                          statement.words.begin() + static_cast<std::ptrdiff_t>(first + count));
    const auto number = [&](std::size_t i) { return numberIn(statement, first + i); };
    const auto ignore = [&] {
        texture.ignored.emplace_back(fmt::format("{} {}", name, fmt::join(values, " ")), statement.places[first - 1]);
    };
    if (name == "-s") texture.scale = {number(0), values.size() > 1 ? number(1) : 1};
    else if (name == "-o") texture.offset = {number(0), values.size() > 1 ? number(1) : 0};
    else if (name == "-mm") { texture.base = number(0); texture.gain = number(1); }
    else if (name == "-bm") texture.bumpMultiplier = number(0);
    else if (name == "-clamp") texture.clamp = values[0] == "on";
    else if (name == "-t") {
        if (std::ranges::any_of(std::views::iota(std::size_t(0), count), [&](std::size_t i) { return number(i) != 0; }))
            ignore();
    } else if (name == "-imfchan") {
        if (values[0] != "m" && values[0] != "l") ignore();
    } else if (name == "-type" || name == "-colorspace" || (name == "-cc" && values[0] == "on")) ignore();
    // -blendu, -blendv, -boost and -texres configure filtering, which the renderer decides.
}

/// The statement of a line.
MtlMaterial::Statement statementIn(const ObjLines& lines) {
    const std::vector<std::string_view>& words = lines.words();
    MtlMaterial::Statement statement{
        .keyword = std::string(words[0]), .words = {words.begin() + 1, words.end()}, .rest = lines.rest(1), .where = lines.where()};
    for (std::size_t i = 1; i < words.size(); ++i) statement.places.push_back(lines.where(i));
    return statement;
}

/// The first statement before any material.
struct EarlyStatement { std::string word; SourceLocation where; };

}  // namespace

SourceLocation MtlMaterial::whereIs(const std::string& keyword) const {
    const auto found = statements.find(keyword);
    return found == statements.end() ? where : found->second.where;
}

std::optional<double> MtlMaterial::number(const std::string& keyword) const {
    const auto found = statements.find(keyword);
    if (found == statements.end()) return {};
    const Statement& statement = found->second;
    const std::size_t at = !statement.words.empty() && statement.words[0] == "-halo" ? 1 : 0;
    if (statement.words.size() <= at) throw SceneError(statement.where, fmt::format("\"{}\" needs a number", statement.keyword));
    return numberIn(statement, at);
}

std::optional<glm::dvec3> MtlMaterial::color(const std::string& keyword) const {
    const auto found = statements.find(keyword);
    if (found == statements.end()) return {};
    const Statement& statement = found->second;
    const std::vector<std::string>& words = statement.words;
    if (!words.empty() && (words[0] == "spectral" || words[0] == "xyz"))
        throw SceneError(statement.places[0],
                         fmt::format("\"{}\" as \"{}\" cannot be read; give red, green and blue", statement.keyword, words[0]));
    if (words.size() == 1) return glm::dvec3(numberIn(statement, 0));
    if (words.size() < 3)
        throw SceneError(statement.where, fmt::format("\"{}\" needs three numbers, and has {}", statement.keyword, words.size()));
    return glm::dvec3(numberIn(statement, 0), numberIn(statement, 1), numberIn(statement, 2));
}

std::optional<MtlTexture> MtlMaterial::texture(const std::string& keyword) const {
    const auto found = statements.find(keyword);
    if (found == statements.end()) return {};
    const Statement& statement = found->second;
    const std::vector<std::string>& words = statement.words;

    // Options come before or after the name; the remaining text, with spaces, is the name.
    MtlTexture texture;
    std::size_t searchFrom = 0, nameBegin = std::string::npos, nameEnd = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto option = std::ranges::find(options, words[i], &Option::name);
        const std::size_t at = statement.rest.find(words[i], searchFrom);
        searchFrom = at + words[i].size();
        if (option == options.end()) {
            if (nameBegin == std::string::npos) texture.where = statement.places[i];
            nameBegin = std::min(nameBegin, at);
            nameEnd = searchFrom;
            continue;
        }
        const std::size_t first = i + 1;
        double ignored = 0;
        while (i + 1 < first + option->most && i + 1 < words.size() &&
               (i + 1 < first + option->least || parseNumber(words[i + 1], ignored))) {
            ++i;
            searchFrom = statement.rest.find(words[i], searchFrom) + words[i].size();
        }
        const std::size_t count = i + 1 - first;
        if (count < option->least)
            throw SceneError(statement.places[first - 1], fmt::format("\"{}\" needs {} more word{}", option->name, option->least,
                                                                      option->least == 1 ? "" : "s"));
        applyOption(texture, statement, option->name, first, count);
    }
    if (nameBegin == std::string::npos) throw SceneError(statement.where, fmt::format("\"{}\" names no image", statement.keyword));
    texture.file = statement.rest.substr(nameBegin, nameEnd - nameBegin);
    std::erase(texture.file, '"');
    return texture;
}

std::vector<MtlMaterial> parseMtl(std::string_view text, const std::shared_ptr<const std::string>& file, Diagnostics& diagnostics) {
    std::vector<MtlMaterial> materials;
    ObjLines lines(text, file);
    std::optional<EarlyStatement> early;
    while (lines.next()) {
        const std::string_view keyword = lines.words()[0];
        if (lower(keyword) == "newmtl") {
            materials.push_back({.name = lines.rest(1), .where = lines.where()});
            if (materials.back().name.empty())
                diagnostics.unsupported("mtl newmtl", lines.where(0), "\"newmtl\" needs the name of a material; this one is skipped");
        } else if (materials.empty()) {
            if (!early) early = {quoteWord(keyword), lines.where(0)};
        } else materials.back().statements[lower(keyword)] = statementIn(lines);
    }
    if (early && !materials.empty())
        diagnostics.unsupported("mtl early statement", early->where,
                                early->word + " belongs to no material and is skipped; it must follow a \"newmtl\"");
    std::erase_if(materials, [](const MtlMaterial& material) { return material.name.empty(); });
    return materials;
}

}  // namespace eikonal
