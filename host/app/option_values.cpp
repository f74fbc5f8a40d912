#include "app/option_values.h"

#include "app/number_in.h"
#include "render/stage_programs.h"
#include "split.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace eikonal {

[[noreturn]] static void refuse(const std::string& option, const std::string& wanted, const std::string& text) {
    throw UsageError(fmt::format("{} takes {}, not \"{}\"", option, wanted, text));
}

/// Exactly N numbers between separators, or nothing.
template <class Number, size_t N> static std::optional<std::array<Number, N>> numbersIn(const std::string& text, char separator) {
    const std::vector<std::string> parts = split(text, separator);
    if (parts.size() != N) return std::nullopt;
    std::array<Number, N> values{};
    for (size_t i = 0; i < N; ++i) {
        const auto value = numberIn<Number>(parts[i]);
        if (!value) return std::nullopt;
        values[i] = *value;
    }
    return values;
}

int parseInteger(const std::string& option, const std::string& text, int low, int high) {
    const auto value = numberIn<int>(text);
    if (value && *value >= low && *value <= high) return *value;
    const bool isTooLarge = !value && numberIn<double>(text).value_or(0) > high;
    const bool unlimited = high == std::numeric_limits<int>::max() && !isTooLarge;
    if (unlimited && low == std::numeric_limits<int>::min()) refuse(option, "a whole number", text);
    refuse(option, unlimited ? fmt::format("a whole number of at least {}", low) : fmt::format("a whole number from {} to {}", low, high),
           text);
}

double parseNumber(const std::string& option, const std::string& text, double low, double high) {
    const auto value = numberIn<double>(text);
    if (value && *value > low && *value < high) return *value;
    if (std::isinf(high)) refuse(option, std::isinf(low) ? "a number" : fmt::format("a number greater than {}", low), text);
    refuse(option, fmt::format("a number between {} and {}", low, high), text);
}

double parseNumberFrom(const std::string& option, const std::string& text, double low, double high) {
    const auto value = numberIn<double>(text);
    if (value && *value >= low && *value < high) return *value;
    refuse(option, std::isinf(high) ? fmt::format("a number of at least {}", low) : fmt::format("a number from {} to below {}", low, high),
           text);
}

int parsePowerOfTwoOrZero(const std::string& option, const std::string& text, int high) {
    const auto value = numberIn<int>(text);
    if (value && *value >= 0 && *value <= high && (*value == 0 || std::has_single_bit(static_cast<unsigned>(*value)))) return *value;
    refuse(option, fmt::format("0 or a power of two up to {}", high), text);
}

/// "2%" as 0.02, or nothing.
static std::optional<double> percentageIn(const std::string& text) {
    if (!text.ends_with('%')) return std::nullopt;
    const auto value = numberIn<double>(text.substr(0, text.size() - 1));
    return value && *value > 0 ? std::optional(*value / 100) : std::nullopt;
}

/// "90", "90s", "10m" or "1h" in seconds, or nothing.
static std::optional<double> durationIn(const std::string& text) {
    std::string digits = text;
    double unit = 1;
    for (const auto& [name, seconds] : {std::pair{'s', 1.}, {'m', 60.}, {'h', 3600.}})
        if (!digits.empty() && digits.back() == name) {
            digits.pop_back();
            unit = seconds;
            break;
        }
    const auto value = numberIn<double>(digits);
    return value && *value > 0 ? std::optional(*value * unit) : std::nullopt;
}

/// "I/N", with 1 <= I <= N, or nothing.
static std::optional<std::array<int, 2>> partIn(const std::string& text) {
    const auto part = numbersIn<int, 2>(text, '/');
    return part && 1 <= (*part)[0] && (*part)[0] <= (*part)[1] ? part : std::nullopt;
}

SampleSelection parseSamples(const std::string& option, const std::string& text) {
    if (const auto part = partIn(text)) return SampleShare{static_cast<unsigned>((*part)[0]), static_cast<unsigned>((*part)[1])};
    const std::vector<std::string> ends = split(text, ':');
    const auto first = numberIn<int>(ends.front()), end = numberIn<int>(ends.back());
    if (ends.size() != 2 || !first || !end || *first < 0 || *first >= *end)
        refuse(option, "a range of samples A:B, with A < B, like 0:64, or part K/M of all, with K from 1 to M, like 2/4", text);
    const SampleRange range{static_cast<unsigned>(*first), static_cast<unsigned>(*end)};
    if (range.first % leafSamples != 0)
        refuse(option,
               fmt::format("ranges that begin at a multiple of {}, like {}:{}", leafSamples, leafBegin(range.first), range.end), text);
    return range;
}

Tile parseTile(const std::string& option, const std::string& text) {
    const auto part = partIn(text);
    if (!part) refuse(option, "a part I/N, with I from 1 to N, like 2/4", text);
    return {(*part)[0], (*part)[1]};
}

double parseDuration(const std::string& option, const std::string& text) {
    if (const auto seconds = durationIn(text)) return *seconds;
    refuse(option, "a time greater than 0 in seconds, minutes or hours, like 90s, 10m or 1h", text);
}

DisplayAddress parseDisplayAddress(const std::string& option, const std::string& text) {
    const auto colon = text.rfind(':');
    std::string host = text.substr(0, colon);
    const std::string port = colon == std::string::npos ? "" : text.substr(colon + 1);
    const bool inBrackets = host.size() > 2 && host.front() == '[' && host.back() == ']';
    if (inBrackets) host = host.substr(1, host.size() - 2);
    const bool isPort = !port.empty() && port.size() <= 5 && std::ranges::all_of(port, [](char c) { return '0' <= c && c <= '9'; }) &&
                        std::stoi(port) > 0 && std::stoi(port) < 65536;
    if (!isPort || host.empty() || (!inBrackets && host.find(':') != std::string::npos))
        refuse(option, "HOST:PORT, like localhost:14158 or [::1]:14158", text);
    return {host, port};
}

std::string Wish::text() const { return kind == Kind::error ? fmt::format("{:g} %", value * 100) : fmt::format("{:g} s", value); }

Wish parseWish(const std::string& option, const std::string& text) {
    if (const auto error = percentageIn(text)) return {Wish::Kind::error, *error};
    if (const auto seconds = durationIn(text)) return {Wish::Kind::seconds, *seconds};
    refuse(option, "a time like 30s or an error like 2%", text);
}

double parseShare(const std::string& option, const std::string& text) {
    if (const auto share = percentageIn(text)) return *share;
    if (const auto value = numberIn<double>(text); value && *value > 0) return *value;
    refuse(option, "a number greater than 0 like 0.02, or a percentage like 2%", text);
}

glm::dvec3 parseVector(const std::string& option, const std::string& text) {
    const auto v = numbersIn<double, 3>(text, ',');
    if (!v) refuse(option, "three numbers separated by commas, like 0,1,5", text);
    return {(*v)[0], (*v)[1], (*v)[2]};
}

std::array<int, 2> parseResolution(const std::string& option, const std::string& text) {
    constexpr int largest = 1 << 20;
    const auto size = numbersIn<int, 2>(text, 'x');
    if (!size || (*size)[0] < 1 || (*size)[1] < 1 || (*size)[0] > largest || (*size)[1] > largest)
        refuse(option, "a width and a height in pixels, like 800x600", text);
    return *size;
}

std::array<double, 4> parseCropWindow(const std::string& option, const std::string& text) {
    const auto w = numbersIn<double, 4>(text, ',');
    const auto ordered = [](double low, double high) { return 0 <= low && low < high && high <= 1; };
    if (!w || !ordered((*w)[0], (*w)[1]) || !ordered((*w)[2], (*w)[3]))
        refuse(option, "x0,x1,y0,y1, fractions of the image with 0 <= x0 < x1 <= 1 and 0 <= y0 < y1 <= 1, like 0.25,0.75,0,0.5", text);
    return *w;
}

PixelBounds parsePixelBounds(const std::string& option, const std::string& text) {
    const auto b = numbersIn<int, 4>(text, ',');
    const auto ordered = [](int low, int high) { return 0 <= low && low < high; };
    if (!b || !ordered((*b)[0], (*b)[1]) || !ordered((*b)[2], (*b)[3]))
        refuse(option, "x0,x1,y0,y1 in pixels with 0 <= x0 < x1 and 0 <= y0 < y1, like 100,200,0,50", text);
    return {(*b)[0], (*b)[1], (*b)[2], (*b)[3]};
}

unsigned parsePowerOfTwo(const std::string& option, const std::string& text) {
    const auto value = numberIn<unsigned>(text);
    constexpr unsigned largest = 1u << 20;
    if (!value || !std::has_single_bit(*value) || *value > largest) refuse(option, "a power of two, like 64", text);
    return *value;
}

StageFlags parseStageFlags(const std::string& option, const std::string& text) {
    const size_t colon = text.find(':'), begin = colon == std::string::npos ? 0 : colon + 1;
    StageFlags result{text.substr(0, begin ? colon : 0), text.substr(begin)};
    if (result.flags == "none") result.flags.clear();
    std::vector<std::pair<std::string, bool>> names{{"", true}};
    for (const StageProgram& program : stagePrograms())
        for (const std::string& name : {std::string(program.row->name), program.name})
            if (names.back().first != name) names.emplace_back(name, true);
    parseName(option + ": the stage", result.stage, names);
    return result;
}

Aovs parseAovs(const std::string& option, const std::string& text) {
    using Channels = std::vector<bool Aovs::*>;
    std::vector<std::pair<const char*, Channels>> names;
    Channels passes, cryptomatte, all;
    for (const AovName& each : aovNames) {
        names.emplace_back(each.name, Channels{each.asked});
        if (each.source == AovSource::passes) passes.push_back(each.asked);
        if (each.source == AovSource::names) cryptomatte.push_back(each.asked);
        if (each.source != AovSource::lightGroups && each.source != AovSource::names) all.push_back(each.asked);
    }
    names.emplace_back("passes", passes);
    names.emplace_back("cryptomatte", cryptomatte);
    names.emplace_back("all", all);
    Aovs aovs;
    for (const std::string& word : split(text, ','))
        for (const auto channel : parseName(option, word, names)) aovs.*channel = true;
    return aovs;
}

}  // namespace eikonal
