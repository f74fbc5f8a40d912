#include "app/trade/paired.h"

#include "app/trade/student.h"

#include <cmath>
#include <numeric>

namespace eikonal {
namespace {

constexpr size_t leastSeeds = 4;

/// Sums over the seeds of both.
struct Sums {
    double ownSquare = 0, square = 0, ownMean = 0, mean = 0, logTime = 0, seeds = 0;
    Sums& add(const SeedResult& own, const SeedResult& other, double sign) {
        ownSquare += sign * own.squaredError;
        square += sign * other.squaredError;
        ownMean += sign * own.mean;
        mean += sign * other.mean;
        logTime += sign * std::log(other.renderSeconds / own.renderSeconds);
        seeds += sign;
        return *this;
    }
    bool isUsable() const { return ownSquare > 0 && square > 0 && ownMean > 0 && mean > 0; }
    double logError() const { return std::log(square / ownSquare) / 2; }
    double logSeconds() const { return logTime / seeds; }
    double logEfficiency() const { return -2 * logError() - logSeconds(); }
    double logEnergy() const { return std::log(mean / ownMean); }
};

/// The logarithm of a ratio and its standard error.
struct LogRatio {
    double value = 0, deviation = 0;
    Interval ratio(int freedom) const {
        const double half = studentQuantile(freedom) * deviation;
        return {std::exp(value), std::exp(value - half), std::exp(value + half)};
    }
    double chance(int freedom) const { return deviation > 0 ? studentTail(value / deviation, freedom) : value == 0 ? 1 : 0; }
};

LogRatio jackknife(const Sums& all, const std::vector<Sums>& without, double (Sums::*figure)() const) {
    const double n = static_cast<double>(without.size());
    double mean = 0, squares = 0;
    for (const Sums& s : without) mean += (s.*figure)() / n;
    for (const Sums& s : without) squares += ((s.*figure)() - mean) * ((s.*figure)() - mean);
    return {(all.*figure)(), std::sqrt((n - 1) / n * squares)};
}

}  // namespace

std::optional<PairedDifference> compareSeeds(const Point& own, const Point& other) {
    const size_t seeds = std::min(own.seeds.size(), other.seeds.size());
    if (seeds < leastSeeds) return std::nullopt;
    Sums all;
    for (size_t i = 0; i < seeds; ++i) all.add(own.seeds[i], other.seeds[i], 1);
    std::vector<Sums> without;
    bool isUsable = all.isUsable();
    for (size_t i = 0; i < seeds; ++i) {
        without.push_back(Sums(all).add(own.seeds[i], other.seeds[i], -1));
        isUsable = isUsable && without.back().isUsable();
    }
    if (!isUsable) return std::nullopt;
    const int freedom = static_cast<int>(seeds) - 1;
    const LogRatio efficiency = jackknife(all, without, &Sums::logEfficiency), energy = jackknife(all, without, &Sums::logEnergy);
    PairedDifference d{.error = jackknife(all, without, &Sums::logError).ratio(freedom),
                       .seconds = jackknife(all, without, &Sums::logSeconds).ratio(freedom),
                       .efficiency = efficiency.ratio(freedom),
                       .energy = energy.ratio(freedom),
                       .chanceOfEfficiency = efficiency.chance(freedom),
                       .chanceOfEnergy = energy.chance(freedom)};
    for (double* bound : {&d.energy.value, &d.energy.low, &d.energy.high}) *bound -= 1;
    return d;
}

}  // namespace eikonal
