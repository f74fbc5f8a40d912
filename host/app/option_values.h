#pragma once
// Parsers for option values. Each throws a UsageError that names the option, the text found, and what would have worked.

#include "app/wish.h"
#include "error.h"
#include "film/sample_nodes.h"
#include "film/tile.h"
#include "render/options.h"
#include "scene/film.h"
#include "view/options.h"

namespace eikonal {

/// A whole number in [low, high].
int parseInteger(const std::string& option, const std::string& text, int low, int high);
/// A finite number in the open interval (low, high).
double parseNumber(const std::string& option, const std::string& text, double low, double high);
/// A finite number in [low, high).
double parseNumberFrom(const std::string& option, const std::string& text, double low, double high);
/// 0, or a power of two of at most `high`.
int parsePowerOfTwoOrZero(const std::string& option, const std::string& text, int high);
/// A number greater than 0, or a percentage: "0.02" or "2%".
double parseShare(const std::string& option, const std::string& text);
/// "x,y,z".
glm::dvec3 parseVector(const std::string& option, const std::string& text);
/// "800x600".
std::array<int, 2> parseResolution(const std::string& option, const std::string& text);
/// "x0,x1,y0,y1", fractions with 0 <= x0 < x1 <= 1 and the same for y.
std::array<double, 4> parseCropWindow(const std::string& option, const std::string& text);
/// "x0,x1,y0,y1", pixels with 0 <= x0 < x1 and the same for y.
PixelBounds parsePixelBounds(const std::string& option, const std::string& text);
/// A power of two in [1, 2^20].
unsigned parsePowerOfTwo(const std::string& option, const std::string& text);
/// "FLAGS", or "STAGE:FLAGS" with the name of a stage; FLAGS "none": no flags.
StageFlags parseStageFlags(const std::string& option, const std::string& text);
/// "all", or names separated by commas.
Aovs parseAovs(const std::string& option, const std::string& text);

/// "A:B", samples A <= i < B, where A begins a leaf (film/sample_nodes.h); or "K/M", with 1 <= K <= M.
SampleSelection parseSamples(const std::string& option, const std::string& text);
/// "I/N", with 1 <= I <= N.
Tile parseTile(const std::string& option, const std::string& text);
/// A time greater than 0 in seconds: "90", "90s", "10m", "1h".
double parseDuration(const std::string& option, const std::string& text);
/// "host:port"; an address of IPv6 in brackets: "[::1]:14158".
DisplayAddress parseDisplayAddress(const std::string& option, const std::string& text);
/// "30s", "2m" or "2%".
Wish parseWish(const std::string& option, const std::string& text);

/// The value that `text` names. `names` is a range of (name, value) pairs.
template <class Names> auto parseName(const std::string& option, const std::string& text, const Names& names) {
    std::string all;
    std::vector<std::string> words;
    for (const auto& [name, value] : names) {
        if (name == text) return value;
        all += (all.empty() ? "" : ", ") + std::string(name);
        words.emplace_back(name);
    }
    const std::string near = nearestWord(text, words);
    throw UsageError(option + " is one of " + all + ", not \"" + text + "\"" + (near.empty() ? "" : "; did you mean " + near + "?"));
}

}  // namespace eikonal
