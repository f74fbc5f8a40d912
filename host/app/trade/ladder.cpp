// How a study measures its points.

#include "app/trade/study.h"

#include "app/trade/setting_renderer.h"
#include "error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace eikonal {
namespace {

constexpr double hopeless = 4;  // settings that need so many times the best one's time are not measured at higher rungs
constexpr double worthCombining = 1.05;

/// relMSE x seconds at a point: the inverse of efficiency.
double costOfError(const Point& p, double squaredError) { return squaredError * p.medianSeconds(); }

double meanSquaredError(const Point& p) {
    double sum = 0;
    for (const SeedResult& s : p.seeds) sum += s.squaredError;
    return sum / static_cast<double>(p.seeds.size());
}

/// That, less two standard errors.
double leastSquaredError(const Point& p) {
    const double mean = meanSquaredError(p), n = static_cast<double>(p.seeds.size());
    double squares = 0;
    for (const SeedResult& s : p.seeds) squares += (s.squaredError - mean) * (s.squaredError - mean);
    return n > 1 ? std::max(0., mean - 2 * std::sqrt(squares / (n - 1) / n)) : mean;
}

}  // namespace

std::vector<double> Study::rungsOf(const Setting& setting) const {
    std::vector<double> all(std::begin(rungs), std::end(rungs));
    if (setting.ladder == Ladder::samples) return all;
    /* Target errors that take about as many samples as the rungs do */
    std::vector<double> targets;
    for (double rung : rungs)
        for (const Point& p : state_.points)
            if (p.setting == 0 && p.rung == rung && !p.seeds.empty() && p.seeds.front().ownError > 0 && rung > rungs[0])
                targets.push_back(std::stod(fmt::format("{:.2g}", p.seeds.front().ownError)));
    return targets;
}

bool Study::isWorthClimbing(size_t setting, double rung) {
    const Point* known = state_.find(setting, rung);
    if (setting == 0 || rung == rungs[0] || (known && !known->seeds.empty())) return true;
    const Point* below = state_.find(setting, rung / 4);
    if (!below || below->seeds.empty() || below->isSameImage || !below->failure.empty()) return false;
    /* Settings that add bias compete with all, others only with their like: low noise is no merit where bias pays for it */
    double best = std::numeric_limits<double>::infinity();
    for (const Point& p : state_.points) {
        const Setting& s = state_.settings[p.setting];
        const bool competes = s.ladder == Ladder::samples && (state_.settings[setting].addsBias || !s.addsBias);
        if (competes && !p.seeds.empty() && p.rung == below->rung) best = std::min(best, costOfError(p, meanSquaredError(p)));
    }
    if (costOfError(*below, leastSquaredError(*below)) > hopeless * best) return false;
    /* More samples would only reduce what noise is left beside the bias */
    const TrueError error = estimateTrueError(*below, loadImages(*below).sums, loadReferences());
    return !state_.settings[setting].isBiased || error.variance > error.biasSquare.value / 4;
}

void Study::climb(size_t setting, double rung, int endSeed) {
    const Setting& s = state_.settings[setting];
    Point* known = state_.find(setting, rung);
    if (known && (!known->failure.empty() || static_cast<int>(known->seeds.size()) >= endSeed)) return;
    report(s.ladder == Ladder::samples ? fmt::format("{}, {:g} samples", s.name(), rung) : fmt::format("{}, error {:g}", s.name(), rung));
    Point point;
    PointImages images;
    if (known) {
        point = *known;
        images = loadImages(point);
    } else {
        point.setting = setting;
        point.rung = rung;
    }
    const References references = loadReferences();
    /* The user's own options are measured whatever it takes; other points end with the budget */
    const auto stop = [&] { return isInterrupted() || (setting > 0 && spent() > request_.budgetSeconds); };
    try {
        SettingRenderer renderer(request_.scene, optionsOf(s, rung, state_.studied));
        point.prepareSeconds = point.seeds.empty() ? renderer.prepareSeconds() : std::min(point.prepareSeconds, renderer.prepareSeconds());
        point.compileSeconds = std::max(point.compileSeconds, renderer.compileSeconds());
        point.compiledKernels = std::max(point.compiledKernels, renderer.compiledKernels());
        while (static_cast<int>(point.seeds.size()) < endSeed) {
            const int seed = static_cast<int>(point.seeds.size()) + 1;
            const TimedImage render = renderer.render(seed, stop);
            if (!render.isFinished) break;
            if (images.sums.seeds == 0) images.first = render.image;
            images.sums.add(render.image);
            point.seeds.push_back({seed, render.renderSeconds, render.meanSamples, render.ownError,
                                   squaredErrorOf(render.image, references), meanOf(render.image)});
        }
    } catch (const Error& error) {
        if (known) point = *known;  // of which there are files
        point.failure = error.what();
    }
    if (point.failure.empty()) {
        if (point.seeds.empty() || (known && point.seeds.size() == known->seeds.size())) return;
        images.save(stemOf(point));
        const Point* own = state_.find(0, rung);
        if (setting > 0 && s.ladder == Ladder::samples && !s.compiles && own && !own->seeds.empty())
            point.isSameImage = images.first.color == loadImages(*own).first.color;
    }
    /* The files of the old seeds stay until the state has the new ones */
    const std::string old = known ? stemOf(*known) : "";
    if (known) *known = point;
    else state_.points.push_back(point);
    save();
    if (!old.empty() && point.failure.empty()) PointImages::remove(old);
}

void Study::climbAll(double until) {
    for (int end = seedsInASession; end <= seeds; end += seedsInASession)
        for (size_t i = 0; i < std::size(rungs); ++i)
            for (size_t setting = 0; setting < state_.settings.size(); ++setting) {
                const Setting& s = state_.settings[setting];
                const std::vector<double> ladder = rungsOf(s);
                if (s.compiles || i >= ladder.size() || isOver(until)) continue;
                if (s.ladder == Ladder::samples && !isWorthClimbing(setting, ladder[i])) continue;
                climb(setting, ladder[i], end);
            }
}

void Study::addCombination() {
    if (isInterrupted() || std::ranges::any_of(state_.settings, [](const Setting& s) { return s.knob == "combination"; })) return;
    const Point* own = state_.find(0, rungs[std::size(rungs) - 1]);
    if (!own || own->seeds.empty()) return;
    const double usual = costOfError(*own, meanSquaredError(*own));
    /* The best value of each knob that adds no bias, if it is better than the user's; with what makes the user's options unbiased */
    Setting combination{"combination", "", {}, false, false, Ladder::samples, false};
    const auto unbiased = std::ranges::find(state_.settings, false, &Setting::isBiased);
    const bool isBiased = state_.settings.front().isBiased && unbiased != state_.settings.end();
    if (isBiased) combination = {"combination", "unbiased", unbiased->options, false, false, Ladder::samples, false};
    int knobs = isBiased ? 1 : 0;
    for (size_t first = 1; first < state_.settings.size();) {
        const std::string& knob = state_.settings[first].knob;
        const Setting* best = nullptr;
        double most = worthCombining;
        for (; first < state_.settings.size() && state_.settings[first].knob == knob; ++first) {
            const Setting& s = state_.settings[first];
            const Point* p = state_.find(first, own->rung);
            if (s.addsBias || !p || s.knob == "unbiased" || s.knob == "colour" || s.knob == "subsurface" ||
                static_cast<int>(p->seeds.size()) < seeds)
                continue;
            const double gain = usual / costOfError(*p, meanSquaredError(*p));
            if (gain > most) {
                most = gain;
                best = &s;
            }
        }
        if (!best) continue;
        ++knobs;
        combination.value += (combination.value.empty() ? "" : " + ") + best->name();
        combination.options = overridden(combination.options, best->options);
    }
    if (knobs < 2) return;
    state_.settings.push_back(combination);
    save();
}

void Study::climbHigher(double until) {
    /* Compiler flags first, where there is time to compile: their figures are few */
    const Point* own = state_.find(0, rungs[1]);
    if (!own) return;
    for (size_t setting = 0; setting < state_.settings.size(); ++setting)
        if (state_.settings[setting].compiles && !isOver(until) && spent() + 2 * own->compileSeconds + costOf(seeds * rungs[1]) < until)
            climb(setting, rungs[1], seeds);
    /* Beyond that, errors would be about those of the references */
    const double top = state_.referenceSamples / 8;
    for (double rung = rungs[std::size(rungs) - 1] * 4; rung <= top; rung *= 4)
        for (size_t setting = 0; setting < state_.settings.size(); ++setting)
            if (state_.settings[setting].ladder == Ladder::samples && !state_.settings[setting].compiles && !isOver(until) &&
                isWorthClimbing(setting, rung) && spent() + costOf(seeds * rung) < until)
                climb(setting, rung, seeds);
}

}  // namespace eikonal
