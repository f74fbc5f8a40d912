#include "read/obj/mtl_ranges.h"

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
    const char *keyword, *written;       ///< in lower case, and as in the format's specification
    double low, high;
    const char* text;                    ///< completes "it must be"
    bool isColor = false;
    bool isWhole = false;
    std::optional<double> otherwise{};   ///< the replacement; nothing: the nearer end
};

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr const char *fraction = "from 0 to 1", *positive = "at least 0";

constexpr Range ranges[] = {
    {.keyword = "kd", .written = "Kd", .low = 0, .high = 1, .text = fraction, .isColor = true},
    {.keyword = "ks", .written = "Ks", .low = 0, .high = 1, .text = fraction, .isColor = true},
    {.keyword = "tf", .written = "Tf", .low = 0, .high = 1, .text = fraction, .isColor = true},
    {.keyword = "ke", .written = "Ke", .low = 0, .high = unlimited, .text = positive, .isColor = true},
    {.keyword = "ns", .written = "Ns", .low = 0, .high = unlimited, .text = positive},
    {.keyword = "ni", .written = "Ni", .low = 0.001, .high = 10, .text = "from 0.001 to 10", .otherwise = 1},  // range in the specification
    {.keyword = "d", .written = "d", .low = 0, .high = 1, .text = fraction},
    {.keyword = "tr", .written = "Tr", .low = 0, .high = 1, .text = fraction},
    {.keyword = "illum", .written = "illum", .low = 0, .high = 10, .text = "a whole number from 0 to 10", .isWhole = true, .otherwise = 2},
    {.keyword = "pr", .written = "Pr", .low = 0, .high = 1, .text = fraction},
    {.keyword = "pm", .written = "Pm", .low = 0, .high = 1, .text = fraction},
    {.keyword = "ps", .written = "Ps", .low = 0, .high = 1, .text = fraction},
    {.keyword = "pc", .written = "Pc", .low = 0, .high = 1, .text = fraction},
    {.keyword = "pcr", .written = "Pcr", .low = 0, .high = 1, .text = fraction},
    {.keyword = "aniso", .written = "aniso", .low = 0, .high = 1, .text = fraction},
};

bool holds(const Range& range, double value) { return value >= range.low && value <= range.high && (!range.isWhole || value == std::floor(value)); }

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
    if (firstBad)
        diagnostics.warn(statement.places[*firstBad], fmt::format("\"{}\" is {}; it counts as {}, since {} must be {}", range.written, fmt::join(found, " "),
                                                                  fmt::join(kept, " "), found.size() > 1 ? "each number" : "it", range.text));
}

}  // namespace

MtlMaterial withinRanges(MtlMaterial material, Diagnostics& diagnostics) {
    for (const Range& range : ranges)
        if (const auto found = material.statements.find(range.keyword); found != material.statements.end()) keepTo(range, found->second, diagnostics);
    return material;
}

}  // namespace eikonal
