#include "read/obj/mtl_ranges.h"

#include "printable.h"
#include "read/obj/lines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace eikonal {
namespace {

/// The range of the numbers after a keyword.
struct Range {
    const char* keyword;                 ///< in lower case
    double low, high;
    const char* text;                    ///< completes "it must be"
    bool isColor = false;
    bool isWhole = false;
    std::optional<double> otherwise{};   ///< the replacement; nothing: the nearer end
};

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr const char *fraction = "from 0 to 1", *positive = "at least 0";

constexpr Range ranges[] = {
    {.keyword = "kd", .low = 0, .high = 1, .text = fraction, .isColor = true},
    {.keyword = "ks", .low = 0, .high = 1, .text = fraction, .isColor = true},
    {.keyword = "tf", .low = 0, .high = 1, .text = fraction, .isColor = true},
    {.keyword = "ke", .low = 0, .high = unlimited, .text = positive, .isColor = true},
    {.keyword = "ns", .low = 0, .high = unlimited, .text = positive},
    {.keyword = "ni", .low = 0.001, .high = 10, .text = "from 0.001 to 10", .otherwise = 1},  // range in the specification
    {.keyword = "d", .low = 0, .high = 1, .text = fraction},
    {.keyword = "tr", .low = 0, .high = 1, .text = fraction},
    {.keyword = "illum", .low = 0, .high = 10, .text = "a whole number from 0 to 10", .isWhole = true, .otherwise = 2},
    {.keyword = "pr", .low = 0, .high = 1, .text = fraction},
    {.keyword = "pm", .low = 0, .high = 1, .text = fraction},
    {.keyword = "ps", .low = 0, .high = 1, .text = fraction},
    {.keyword = "pc", .low = 0, .high = 1, .text = fraction},
    {.keyword = "pcr", .low = 0, .high = 1, .text = fraction},
    {.keyword = "aniso", .low = 0, .high = 1, .text = fraction},
};

bool holds(const Range& range, double value) {
    return value >= range.low && value <= range.high && (!range.isWhole || value == std::floor(value));
}

/// Words from number `end` on follow the last number, and the parser of the statement does not read them.
void warnOfExtraWords(const Range& range, const MtlMaterial::Statement& statement, std::size_t end, Diagnostics& diagnostics) {
    if (statement.words.size() <= end) return;
    diagnostics.unsupported("mtl extra word of " + statement.keyword, statement.places[end],
                            fmt::format("\"{}\" takes {}: {} after {} does not count", statement.keyword,
                                        range.isColor ? "three numbers" : "one number", quoteWord(statement.words[end]),
                                        range.isColor ? "them" : "it"));
}

void keepTo(const Range& range, MtlMaterial::Statement& statement, Diagnostics& diagnostics) {
    const std::size_t first = !statement.words.empty() && statement.words[0] == "-halo" ? 1 : 0;
    const std::size_t end = std::min(statement.words.size(), first + (range.isColor ? 3 : 1));
    std::optional<std::size_t> firstBad;
    std::vector<std::string> found, kept;
    for (std::size_t i = first; i < end; ++i) {
        std::string& word = statement.words[i];
        double value = 0;
        if (!parseNumber(word, value)) return;
        found.push_back(word);
        if (!holds(range, value)) {
            if (!firstBad) firstBad = i;
            word = fmt::format("{}", range.otherwise.value_or(std::clamp(value, range.low, range.high)));
        }
        kept.push_back(word);
    }
    warnOfExtraWords(range, statement, end, diagnostics);
    if (firstBad)
        diagnostics.warn(statement.places[*firstBad],
                         fmt::format("\"{}\" is {}; it counts as {}, since {} must be {}", statement.keyword, fmt::join(found, " "),
                                     fmt::join(kept, " "), found.size() > 1 ? "each number" : "it", range.text));
}

}  // namespace

MtlMaterial withinRanges(MtlMaterial material, Diagnostics& diagnostics) {
    for (const Range& range : ranges)
        if (const auto found = material.statements.find(range.keyword); found != material.statements.end())
            keepTo(range, found->second, diagnostics);
    return material;
}

}  // namespace eikonal
