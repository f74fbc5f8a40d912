#include "app/trade/model.h"

#include "film/noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace eikonal {
namespace {

constexpr double steepest = -2, flattest = -0.5;         // slopes that a fit may have
constexpr double usualSlope = -1.05, slopeSpread = 0.2;  // before anything is measured
constexpr double mostSamples = 1 << 24;

/// The last of three significant bits of a number of samples.
double unitOf(double samples) { return std::exp2(std::max(std::floor(std::log2(std::max(samples, 1.))) - 2, 0.)); }
/// A number of samples with three significant bits, so that sequences are sampled evenly, at most `samples`.
double roundSamples(double samples) { return std::max(1., std::floor(samples / unitOf(samples)) * unitOf(samples)); }

/// A line through (log n, log variance), with prior knowledge of its slope (Bayesian linear regression with a normal prior).
struct Line {
    double intercept = 0;
    Interval slope;
};
Line fitLine(const std::vector<MeasuredPoint>& points) {
    /* Each variance is known to about this share, and higher rungs matter more: roulette and guides are chosen for long renders */
    double weights = 0, meanX = 0, meanY = 0;
    const auto weightOf = [&](const MeasuredPoint& p) { return p.error.variance > 0 ? p.samples : 0; };
    for (const MeasuredPoint& p : points) {
        const double w = weightOf(p);
        if (w == 0) continue;
        weights += w;
        meanX += w * std::log(p.samples);
        meanY += w * std::log(p.error.variance);
    }
    if (weights == 0) return {-INFINITY, {usualSlope, usualSlope, usualSlope}};
    meanX /= weights;
    meanY /= weights;
    double xx = 0, xy = 0, n = 0;
    for (const MeasuredPoint& p : points) {
        const double w = weightOf(p) / weights, x = std::log(p.samples) - meanX;
        if (w == 0) continue;
        ++n;
        xx += w * x * x;
        xy += w * x * (std::log(p.error.variance) - meanY);
    }
    constexpr double noise = 0.1;  // of the logarithm of a variance
    const double precision = n * xx / (noise * noise) + 1 / (slopeSpread * slopeSpread);
    const double slope = std::clamp((n * xy / (noise * noise) + usualSlope / (slopeSpread * slopeSpread)) / precision, steepest, flattest);
    const double half = 1.96 / std::sqrt(precision);
    return {meanY - slope * meanX, {slope, slope - half, slope + half}};
}

}  // namespace

double MeasuredPoint::relativeError() const { return std::sqrt(std::max(error.square.value, 0.)); }

double SettingModel::variance(double samples) const {
    if (!isUniform || slope.value >= -1 || samples < 1) return variance1 * std::pow(samples, slope.value);
    const auto n = static_cast<unsigned>(std::min(samples, mostSamples));
    return variance1 * std::pow(std::bit_floor(n), slope.value) * varianceScale(n, -slope.value);
}

double SettingModel::error(double samples) const { return std::sqrt(biasSquare + variance(samples)); }

double SettingModel::uncertaintyAt(double samples) const {
    const double steps = std::abs(std::log(samples / lastSamples)), square = error(samples) * error(samples);
    const double noise = square > 0 ? (square - biasSquare) / square : 0;  // the part that the slope is of
    return std::hypot(uncertainty, (slope.high - slope.low) / 4 * steps * noise);
}

std::optional<double> SettingModel::samplesForError(double error) const {
    const double left = error * error - biasSquare;
    if (left <= 0) return std::nullopt;
    double samples = std::max(1., std::ceil(variance1 > 0 ? std::pow(left / variance1, 1 / slope.value) : 1));
    /* The next number of three significant bits that is enough */
    while (isUniform && samples <= mostSamples && variance(samples) > left * (1 + 1e-9)) samples = roundSamples(samples) + unitOf(samples);
    if (samples > mostSamples) return std::nullopt;
    return samples;
}

std::optional<double> SettingModel::samplesInTime(double seconds) const {
    const double samples = roundSamples((seconds - fixedSeconds) / secondsPerSample);
    if (seconds < fixedSeconds + secondsPerSample) return std::nullopt;
    return std::min(samples, mostSamples);
}

SettingModel fitModel(const std::vector<MeasuredPoint>& points, const Setting& setting, double pixels, double fixedSeconds, double pace) {
    SettingModel m;
    const MeasuredPoint& last = points.back();
    m.setting = last.setting;
    m.isExact = !setting.isBiased;
    m.isUniform = setting.ladder == Ladder::samples;
    /* The bias of the point with the least noise, but not less than that noise */
    if (const Interval& b = last.error.biasSquare; setting.isBiased) m.biasSquare = std::max({b.value, (b.high - b.value) / 2, 0.});
    const Line line = fitLine(points);
    m.slope = line.slope;
    m.variance1 = std::exp(line.intercept);
    m.fixedSeconds = fixedSeconds;
    m.secondsPerSample = last.secondsPerPath * pixels * pace;
    m.rungs = points.size();
    m.lastRung = last.rung;
    m.lastSamples = last.samples;
    const Interval& square = last.error.square;
    constexpr double concentrated = 0.25;  // where noise is spread over the image, 0.01 to 0.1
    m.isReliable = std::ranges::none_of(points, [](const MeasuredPoint& p) { return p.error.concentration > concentrated; });
    m.uncertainty = square.value > 0 ? (square.high - square.low) / 4 / square.value : 1;
    return m;
}

Recommendation recommend(const Wish& wish, const std::vector<SettingModel>& models, const std::vector<Setting>& settings) {
    Recommendation best;
    best.wish = wish;
    double least = INFINITY;
    for (const SettingModel& m : models) {
        const bool isForError = wish.kind == Wish::Kind::error;
        const std::optional<double> samples = isForError ? m.samplesForError(wish.value) : m.samplesInTime(wish.value);
        if (!samples) continue;
        /* The less is known, the more it counts, but an error far below the wish may be uncertain. Of nearly equal ones the first: the
           user's own options before others */
        const double seconds = m.seconds(*samples), error = m.error(*samples), uncertainty = m.uncertaintyAt(*samples);
        const double risk = std::min(1., uncertainty * (isForError ? error / wish.value : 0.5));
        const double doubt = settings[m.setting].compiles ? 0.1 : 0;  // flags that are not strict must be worth it
        const double cost = (isForError ? seconds : error) * (1 + risk) * (1 + doubt);
        if (cost > (isForError ? 0.95 : 0.975) * least) continue;
        least = cost;
        const bool isAdaptive = settings[m.setting].ladder == Ladder::targetErrors;
        const double extrapolation = *samples / m.lastSamples;
        const double rung = isAdaptive ? m.lastRung * std::pow(extrapolation, m.slope.value / 2) : *samples;
        best = {.wish = wish,
                .isPossible = true,
                .setting = m.setting,
                .samples = *samples,
                .rung = rung,
                .seconds = seconds,
                .error = error,
                .uncertainty = uncertainty,
                .isReliable = m.isReliable,
                .extrapolation = extrapolation};
    }
    return best;
}

void markFront(std::vector<MeasuredPoint>& points) {
    for (MeasuredPoint& p : points)
        p.isOnFront = std::ranges::none_of(points, [&](const MeasuredPoint& q) {
            return q.seconds <= p.seconds && q.relativeError() <= p.relativeError() &&
                   (q.seconds < p.seconds || q.relativeError() < p.relativeError());
        });
}

}  // namespace eikonal
