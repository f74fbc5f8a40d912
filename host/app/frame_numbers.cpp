#include "app/frame_numbers.h"

#include "app/number_in.h"
#include "error.h"
#include "split.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <unordered_set>

namespace eikonal {
namespace {

constexpr char place = '#';

/// All of `text` as a number from 0 without a sign, or nothing.
std::optional<int> frameIn(std::string_view text) {
    return text.starts_with('-') || text.starts_with('+') ? std::nullopt : numberIn<int>(std::string(text));
}

struct FrameRange {
    int first, last, step;
};

/// "A", "A-B" or "A-B:S"; nothing if it is none of these.
std::optional<FrameRange> rangeIn(std::string_view text) {
    const size_t colon = text.find(':'), dash = text.substr(0, colon).find('-', 1);
    const auto first = frameIn(text.substr(0, std::min(dash, colon)));
    const auto last = dash == text.npos ? first : frameIn(text.substr(dash + 1, colon - dash - 1));
    const auto step = colon == text.npos ? std::optional(1) : frameIn(text.substr(colon + 1));
    if (!first || !last || !step || *step < 1 || (dash == text.npos && colon != text.npos)) return {};
    return FrameRange{*first, *last, *step};
}

/// Where the name of the file begins.
size_t nameBegin(const std::string& path) {
    const size_t slash = path.rfind('/');
    return slash == path.npos ? 0 : slash + 1;
}

}  // namespace

std::vector<int> parseFrames(const std::string& option, const std::string& text) {
    std::vector<int> frames;
    std::unordered_set<int> known;
    for (const std::string& word : split(text, ',')) {
        const auto range = rangeIn(word);
        if (!range)
            throw UsageError(
                fmt::format("{} takes whole numbers from 0 and ranges of them, like 1-10, 1-10:2 or 1-10:2,20, not \"{}\"", option, word));
        if (range->first > range->last)
            throw UsageError(fmt::format("{}: the range {} goes down; write {}-{}", option, word, range->last, range->first));
        if ((range->last - range->first) / range->step >= mostFrames)
            throw UsageError(fmt::format("{}: {} are more than {} frames, the most that one call renders", option, word, mostFrames));
        for (long frame = range->first; frame <= range->last; frame += range->step)
            if (known.insert(static_cast<int>(frame)).second) frames.push_back(static_cast<int>(frame));
    }
    if (frames.size() > static_cast<size_t>(mostFrames))
        throw UsageError(fmt::format("{}: {} frames are more than {}, the most that one call renders", option, frames.size(), mostFrames));
    return frames;
}

bool hasFramePlace(const std::string& path) { return path.find(place, nameBegin(path)) != path.npos; }

std::string withFrame(const std::string& path, int frame) {
    std::string result = path.substr(0, nameBegin(path));
    for (size_t i = result.size(); i < path.size();) {
        size_t end = i;
        while (end < path.size() && path[end] == place) ++end;
        if (end > i) result += fmt::format("{:0{}}", frame, end - i);
        else result += path[end++];
        i = end;
    }
    return result;
}

std::string frameRanges(const std::vector<int>& frames) {
    std::string text;
    for (size_t i = 0; i < frames.size();) {
        size_t end = i + 1;
        while (end < frames.size() && frames[end] == frames[end - 1] + 1) ++end;
        text += (text.empty() ? "" : ", ") + std::to_string(frames[i]);
        if (end - i > 1) text += "-" + std::to_string(frames[end - 1]);
        i = end;
    }
    return text;
}

}  // namespace eikonal
