#include "app/progress_display.h"

#include "clock.h"
#include "json_text.h"
#include "names.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace eikonal {
namespace {

constexpr double secondsBetweenFrames = 0.1, secondsBetweenRecords = 1, secondsBetweenLines = 10;
/// Estimating the error takes at most this share of the time.
constexpr double shareForErrors = 0.01;
constexpr int widestBar = 30, narrowestBar = 8;

double pauseOf(ProgressForm form) {
    switch (form) {
        case ProgressForm::bar: return secondsBetweenFrames;
        case ProgressForm::json:
        case ProgressForm::openjd: return secondsBetweenRecords;
        default: return secondsBetweenLines;
    }
}

/// Rounded down to a multiple of 1 / parts.
double roundedDown(double x, double parts) { return std::floor(x * parts) / parts; }

}  // namespace

std::vector<std::string> progressParts(const Progress& p, unsigned samples, const RenderPlace& place) {
    std::vector<std::string> parts{fmt::format("{:3.0f} %", std::floor(p.fraction * 100))};
    if (place.inAll > 1)
        parts.push_back(fmt::format("{}{} of {}", place.frame ? fmt::format("frame {}, ", *place.frame) : "", place.number, place.inAll));
    if (p.secondsLeft) parts.push_back(fmt::format("{} left", clockTime(*p.secondsLeft)));
    parts.push_back(fmt::format("{}/{} samples", std::floor(p.meanSamples), samples));
    parts.push_back(fmt::format("{} elapsed", clockTime(p.seconds)));
    return parts;
}

std::string clockTime(double seconds) {
    const long s = static_cast<long>(seconds);
    return s >= 3600 ? fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60) : fmt::format("{}:{:02}", s / 60, s % 60);
}

std::string progressBar(double fraction, std::vector<std::string> parts, int width) {
    constexpr int frame = 3;   // "[] "
    const auto text = [&] { return fmt::format("{}", fmt::join(parts, "  ")); };
    const auto room = [&] { return width - static_cast<int>(text().size()); };
    while (parts.size() > 1 && room() < frame + narrowestBar) parts.pop_back();
    const int bar = std::min(room() - frame, widestBar);
    if (bar < 1) return text();
    const int full = static_cast<int>(fraction * bar);
    return fmt::format("[{:=<{}}{: <{}}] {}", "", full, "", bar - full, text());
}

ProgressDisplay::ProgressDisplay(Subject subject, bool isShown)
    : subject_(std::move(subject)), isShown_(isShown), form_(progressForm()), shownAt_(form_ == ProgressForm::plain ? 0 : -pauseOf(form_)) {
    last_.meanSamples = subject_.samples;
}

ProgressDisplay::~ProgressDisplay() {
    if (form_ == ProgressForm::bar) endStatus(true);
}

void ProgressDisplay::show(Progress p) {
    last_ = p;
    if (p.seconds - loggedAt_ >= secondsBetweenLines) {
        loggedAt_ = p.seconds;
        logProgress(fmt::format("{}", fmt::join(partsOf(p), "  ")));
    }
    if (!isShown_ || p.seconds - shownAt_ < pauseOf(form_) || p.fraction >= 1) return;   // the end is told by end()
    shownAt_ = p.seconds;
    print(p);
}

void ProgressDisplay::end(bool isFinished) {
    if (isFinished) last_.fraction = 1;
    last_.secondsLeft = 0;
    if (isShown_ && form_ != ProgressForm::plain) print(last_);
}

void ProgressDisplay::print(const Progress& p) {
    switch (form_) {
        case ProgressForm::json: printJson(p); break;
        case ProgressForm::openjd: printOpenJd(p); break;
        case ProgressForm::bar: drawStatus(progressBar(p.fraction, partsOf(p), statusWidth())); break;
        default: printProgress(fmt::format("{}", fmt::join(partsOf(p), "  ")));
    }
}

/// Estimates anew if that is due.
const std::optional<ErrorEstimate>& ProgressDisplay::error(const Progress& p) {
    if (p.samples == 0 || p.seconds < errorDue_) return error_;
    const Stopwatch time;
    error_ = subject_.error();
    errorDue_ = p.seconds + time.seconds() / shareForErrors;
    return error_;
}

void ProgressDisplay::printJson(const Progress& p) {
    constexpr double shares = 1e4, milliseconds = 1e3;
    nlohmann::ordered_json json{{"event", "progress"},
                                {"fraction", roundedDown(p.fraction, shares)},
                                {"samplesDone", static_cast<std::uint64_t>(p.meanSamples)},
                                {"samplesInAll", subject_.samples},
                                {"seconds", roundedDown(p.seconds, milliseconds)},
                                {"secondsLeft", nullptr},
                                {"error", nullptr}};
    if (p.secondsLeft) json["secondsLeft"] = roundedDown(*p.secondsLeft, milliseconds);
    if (subject_.place.frame) json["frame"] = *subject_.place.frame;
    if (subject_.place.inAll > 1) {
        json["render"] = subject_.place.number;
        json["rendersInAll"] = subject_.place.inAll;
    }
    if (const auto& e = error(p)) {
        json["error"] = {{"metric", nameIn(errorMetricNames, subject_.metric)}, {"value", e->error}, {"low", e->low}, {"high", e->high}};
        if (!e->doubt.empty()) json["error"]["doubt"] = e->doubt;
    }
    printProgress(jsonText(json));
}

void ProgressDisplay::printOpenJd(const Progress& p) {
    constexpr double tenths = 10;
    const double done = static_cast<double>(subject_.place.number - 1) + p.fraction;   // of all renders
    percent_ = std::max(percent_, roundedDown(100 * done / static_cast<double>(subject_.place.inAll), tenths));
    std::vector<std::string> parts = partsOf(p);
    parts.front() = "rendering";
    if (const auto& e = error(p)) parts.push_back(describe(*e, subject_.metric));
    printProgress(fmt::format("openjd_progress: {:.1f}\nopenjd_status: {}", percent_, fmt::join(parts, ", ")));
}

}  // namespace eikonal
