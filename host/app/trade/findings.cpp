#include "app/trade/findings.h"

#include "app/trade/pictures.h"
#include "error.h"
#include "image/flip.h"
#include "shell_word.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

/// Seconds besides rendering before any run at full size is known: the program's start.
constexpr double usualStart = 0.3;

/// The run of a setting at full size with the most samples, or null.
const Confirmation* longest(const StudyState& state, size_t setting) {
    const Confirmation* best = nullptr;
    for (const Confirmation& c : state.confirmations)
        if (c.setting == setting && c.failure.empty() && (!best || c.meanSamples > best->meanSamples)) best = &c;
    return best;
}

/// `own`: the point of the user's own options at the same rung, or null.
MeasuredPoint measure(const Point& p, const Point* own, const PointImages& images, const References& references) {
    MeasuredPoint m;
    m.setting = p.setting;
    m.rung = p.rung;
    m.samples = p.meanSamples();
    m.seeds = static_cast<int>(p.seeds.size());
    m.secondsPerPath = p.medianSeconds() / (m.samples * static_cast<double>(images.first.pixelCount()));
    m.compileSeconds = p.compileSeconds;
    m.prepareSeconds = p.prepareSeconds;
    m.compiledKernels = p.compiledKernels;
    m.error = estimateTrueError(p, images.sums, references);
    if (own && own != &p) m.paired = compareSeeds(*own, p);
    return m;
}

/// Measures the rungs that are missing below a recommendation. Returns whether there were any.
bool climbFurther(Study& study, const Findings& found) {
    bool hasClimbed = false;
    for (const Recommendation& r : found.recommendations) {
        if (!r.isPossible || study.state().settings[r.setting].ladder != Ladder::samples) continue;
        for (double rung : Study::rungs) {
            const Point* known = study.state().find(r.setting, rung);
            const bool isKnown = known && static_cast<int>(known->seeds.size()) == Study::seeds;
            if (isKnown || rung > r.samples || !study.canAfford(rung)) continue;
            study.climb(r.setting, rung, Study::seeds);
            hasClimbed = true;
        }
    }
    return hasClimbed;
}

}  // namespace

Findings measureErrors(const Study& study, bool withFlip) {
    const StudyState& state = study.state();
    Findings found;
    constexpr int leastSeeds = 2;  // for a variance
    if (state.ladderOf(0, leastSeeds).empty())
        throw Error(ExitCode::scene,
                    "the budget was spent before anything was measured; give more with --budget, or a smaller --resolution");
    found.references = study.loadReferences();
    const FilmImage reference = found.references.mean();
    found.mapping.exposure = exposureFor(meanOf(reference));
    const std::vector<const Point*> own = state.ladderOf(0, leastSeeds);
    const auto ownAt = [&](double rung) {
        const auto at = std::ranges::find(own, rung, &Point::rung);
        return at == own.end() ? nullptr : *at;
    };
    for (size_t setting = 0; setting < state.settings.size(); ++setting)
        for (const Point* p : state.ladderOf(setting, leastSeeds)) {
            const PointImages images = study.loadImages(*p);
            found.points.push_back(measure(*p, ownAt(p->rung), images, found.references));
            if (withFlip) found.points.back().flip = flipMean(images.first, reference, found.mapping);
        }
    return found;
}

Verdict efficiencyVerdict(const Findings& findings, const MeasuredPoint& p) {
    if (!p.paired || p.paired->chanceOfEfficiency >= findings.significant) return Verdict::none;
    return p.paired->efficiency.value > 1 ? Verdict::better : Verdict::worse;
}

bool isUnexpectedlyBiased(const Findings& findings, const Setting& setting, const MeasuredPoint& p) {
    return !setting.isBiased && p.error.chanceOfBias < findings.significant;
}

/// The variance of a pixel of the whole image over that of one at the measured size: a larger pixel has more edges and texture in it.
struct VarianceScale {
    double factor = 1;
    double deviation = 0;   ///< of its logarithm
};
/// By what the samples say about the error of both sizes. `run`: at full size, or null. ofRun: the model of its setting.
static VarianceScale varianceScale(const StudyState& state, const Confirmation* run, const SettingModel& ofRun) {
    /* Of the logarithm, before anything is known of the scene at full size */
    constexpr double usualDeviation = 0.5;
    if (state.studied == state.full) return {};
    const VarianceScale unknown{1, usualDeviation};
    if (!run || run->ownError <= 0) return unknown;
    const Point* nearest = nullptr;
    const auto distance = [run](const Point* p) { return std::abs(std::log(p->meanSamples() / run->meanSamples)); };
    for (const Point* p : state.ladderOf(run->setting))
        if (!nearest || distance(p) < distance(nearest)) nearest = p;
    if (!nearest) return unknown;
    double square = 0;
    for (const SeedResult& s : nearest->seeds) square += s.ownError * s.ownError / static_cast<double>(nearest->seeds.size());
    square *= ofRun.variance(run->meanSamples) / ofRun.variance(nearest->meanSamples());
    if (square <= 0) return unknown;
    /* A normal prior; the deviation of a square is twice that of its root */
    const double measured = std::log(run->ownError * run->ownError / square), deviation = 2 * run->errorDeviation;
    const double share = usualDeviation * usualDeviation / (usualDeviation * usualDeviation + deviation * deviation);
    return {std::exp(share * measured), std::sqrt(share) * deviation};
}

void predict(const Study& study, const std::vector<Wish>& wishes, Findings& found) {
    const StudyState& state = study.state();
    const double pixels = pixelsOf(state.full);
    const auto ladderOf = [&](size_t setting) { return std::ranges::equal_range(found.points, setting, {}, &MeasuredPoint::setting); };
    const Confirmation* own = longest(state, 0);
    found.models.clear();
    for (size_t setting = 0; setting < state.settings.size(); ++setting) {
        const auto points = ladderOf(setting);
        if (points.empty()) continue;
        /* Runs at full size correct the times: those of this setting, or else of the user's own */
        const Confirmation* run = longest(state, setting);
        const Confirmation* known = run ? run : own;
        double pace = 1, fixed = usualStart + points.front().prepareSeconds;
        if (known) {
            pace = known->renderSeconds / (known->meanSamples * pixels) / ladderOf(known->setting).back().secondsPerPath;
            fixed = std::max(known->fixedSeconds(), 0.);
        }
        for (MeasuredPoint& p : points) p.seconds = fixed + p.secondsPerPath * p.samples * pixels * pace;
        found.models.push_back(fitModel({points.begin(), points.end()}, state.settings[setting], pixels, fixed, pace));
        SettingModel& model = found.models.back();
        const VarianceScale scale = varianceScale(state, known, run ? model : found.models.front());
        model.variance1 *= scale.factor;
        /* Bias does not depend on the size */
        const double noise = model.variance(model.lastSamples), whole = noise + model.biasSquare;
        model.uncertainty = std::hypot(model.uncertainty, whole > 0 ? 1.96 * scale.deviation / 2 * noise / whole : 0);
    }
    found.significant = significantChance(found.models.size());
    markFront(found.points);
    found.recommendations.clear();
    for (const Wish& wish : wishes) {
        found.recommendations.push_back(recommend(wish, found.models, state.settings));
        Recommendation& r = found.recommendations.back();
        r.referenceError = found.references.relativeError();
        if (!r.isPossible || r.setting == 0) continue;
        const auto points = ladderOf(r.setting);
        /* Or the user's own options have more bias than that, however many samples they get */
        const auto ownPoints = ladderOf(0);
        const bool isOutOfReach =
            state.settings[0].isBiased && !ownPoints.empty() && ownPoints.back().error.biasSquare.low > r.error * r.error;
        r.isBetter = isOutOfReach ||
                     std::ranges::any_of(points, [&](const MeasuredPoint& p) { return efficiencyVerdict(found, p) == Verdict::better; });
    }
}

void confirmRecommendations(Study& study, const std::vector<Wish>& wishes) {
    const StudyState& state = study.state();
    const double budget = study.request().budgetSeconds;
    Findings found = measureErrors(study, false);
    for (int round = 0; round < 8; ++round) {
        predict(study, wishes, found);
        if (climbFurther(study, found)) {
            found = measureErrors(study, false);
            predict(study, wishes, found);
        }
        std::vector<const SettingModel*> open;
        for (const SettingModel& m : found.models) {
            const bool isWanted = m.setting == 0 || std::ranges::any_of(found.recommendations, [&](const Recommendation& r) {
                                      return r.isPossible && r.setting == m.setting;
                                  });
            const bool isTried = std::ranges::any_of(state.confirmations, [&](const Confirmation& c) { return c.setting == m.setting; });
            if (isWanted && !isTried) open.push_back(&m);
        }
        if (open.empty()) return;
        for (const SettingModel* m : open) {
            const double left = budget - study.spent();
            if (left <= 0 || study.isInterrupted()) return;
            /* As many samples as fit into a part of what is left, but not more than a wish takes */
            const Setting& s = state.settings[m->setting];
            double wished = std::max(m->lastSamples, 16.);
            for (const Recommendation& r : found.recommendations)
                if (r.isPossible && r.setting == m->setting) wished = std::max(wished, r.samples);
            const double samples = std::max(1., std::min(std::floor(std::min(left / 6, 20.) / m->secondsPerSample), wished));
            const double rung =
                s.ladder == Ladder::samples ? samples : m->lastRung * std::pow(samples / m->lastSamples, m->slope.value / 2);
            study.confirmAt(m->setting, rung);
        }
    }
}

static std::string command(const Study& study, const std::vector<std::string>& options) {
    std::string text = "eikonal render " + shellWord(study.request().scene);
    for (const std::string& option : options) text += " " + shellWord(option);
    return text;
}

std::string commandOf(const Study& study, size_t setting, double rung) {
    return command(study, study.optionsOf(study.state().settings[setting], rung));
}

std::string measuredCommand(const Study& study, size_t setting, double rung) {
    return command(study, overridden(study.optionsOf(study.state().settings[setting], rung, study.state().studied), {"--seed=1"}));
}

std::string caveats(const Recommendation& r) {
    std::string text;
    if (r.extrapolation > 8) text += fmt::format("; extrapolated: {:.0f} times the samples that were measured", r.extrapolation);
    if (r.error < r.referenceError) text += fmt::format("; below the references' error of {:.2g} %", r.referenceError * 100);
    if (!r.isBetter) text += "; not significantly better than the options as given";
    constexpr double mostReferenceError = 0.1;   // what errors are relative to is as uncertain
    if (r.referenceError > mostReferenceError) text += "; not reliable: the budget was too short for references";
    if (!r.isReliable) text += "; not reliable: a few bright pixels hold most of the variance";
    return text;
}

std::string describe(const Study& study, const Recommendation& r) {
    if (!r.isPossible)
        return fmt::format("for {}: nothing that was measured {}", r.wish.text(),
                           r.wish.kind == Wish::Kind::error ? "reaches this error" : "is so fast; use a lower --resolution");
    return fmt::format("for {}: {}   ({:.3g} s, error {:.2g} % +- {:.1g} %{})", r.wish.text(), commandOf(study, r.setting, r.rung),
                       r.seconds, r.error * 100, r.error * r.uncertainty * 100, caveats(r));
}

}  // namespace eikonal
