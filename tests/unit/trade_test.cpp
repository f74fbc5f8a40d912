// What `eikonal trade` computes from renders: true errors, models of settings, and recommendations.

#include "app/option_values.h"
#include "app/trade/true_error.h"
#include "app/trade/model.h"
#include "app/trade/student.h"
#include "app/trade/study_state.h"
#include "app/trade/svg_plot.h"
#include "error.h"
#include "temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace eikonal {
namespace {

constexpr int side = 32;

/// An image of a scene whose true radiance is 1, times `factor`, with independent normal noise in each channel.
FilmImage noisy(std::mt19937& random, double deviation, double factor = 1) {
    FilmImage image(side, side);
    std::normal_distribution<float> noise(0, static_cast<float>(deviation));
    for (glm::vec3& c : image.color) c = glm::vec3(static_cast<float>(factor)) + glm::vec3(noise(random), noise(random), noise(random));
    return image;
}

TrueError estimate(std::mt19937& random, int seeds, double deviation, double factor, const References& references) {
    SeedSums sums;
    std::vector<double> squares, means;
    for (int i = 0; i < seeds; ++i) {
        const FilmImage image = noisy(random, deviation, factor);
        sums.add(image);
        squares.push_back(squaredErrorOf(image, references));
        means.push_back(meanOf(image));
    }
    return estimateTrueError(sums, squares, means, references);
}

TEST(TradeError, SplitsIntoBiasAndVarianceWithoutTheReferencesNoise) {
    /* relMSE divides by 1 + 0.01. The references' own variance of 0.0025 must appear neither in the products nor by the divisors */
    std::mt19937 random(1);
    const References references{noisy(random, 0.05), noisy(random, 0.05)};
    const TrueError e = estimate(random, 64, 0.2, 1.1, references);
    EXPECT_NEAR(e.variance, 0.04 / 1.01, 0.001);
    EXPECT_NEAR(e.biasSquare.value, 0.01 / 1.01, 0.0005);
    EXPECT_NEAR(e.square.value, 0.05 / 1.01, 0.002);
    EXPECT_NEAR(e.energy.value, 0.1, 0.01);
    EXPECT_NEAR(references.relativeError(), 0.05 / std::sqrt(2 * 1.01), 0.001);
}

TEST(TradeError, IntervalsHoldTheTruth) {
    std::mt19937 random(2);
    int square = 0, bias = 0, energy = 0;
    constexpr int trials = 100;
    for (int i = 0; i < trials; ++i) {
        const References references{noisy(random, 0.02), noisy(random, 0.02)};
        const TrueError e = estimate(random, 8, 0.3, 1.05, references);
        const auto holds = [](const Interval& found, double truth) { return found.low <= truth && truth <= found.high; };
        square += holds(e.square, (0.09 + 0.0025) / 1.01);
        bias += holds(e.biasSquare, 0.0025 / 1.01);
        energy += holds(e.energy, 0.05);
    }
    /* 95 of 100 are expected; fewer than 88 would happen once in 400 times */
    EXPECT_GE(square, 88);
    EXPECT_GE(bias, 88);
    EXPECT_GE(energy, 88);
}

/// As noisy(), but the channels of a pixel err together, as light that is not coloured makes them.
FilmImage grey(std::mt19937& random, double deviation, double factor) {
    FilmImage image = noisy(random, deviation, factor);
    for (glm::vec3& c : image.color) c = glm::vec3(c.x);
    return image;
}

TEST(TradeError, IntervalsHoldTheTruthWhereChannelsErrTogether) {
    std::mt19937 random(4);
    int square = 0, bias = 0;
    for (int i = 0; i < 100; ++i) {
        const References references{grey(random, 0.03, 1), grey(random, 0.03, 1)};
        SeedSums sums;
        std::vector<double> squares, means;
        for (int seed = 0; seed < 8; ++seed) {
            const FilmImage image = grey(random, 0.1, 1.1);
            sums.add(image);
            squares.push_back(squaredErrorOf(image, references));
            means.push_back(meanOf(image));
        }
        const TrueError e = estimateTrueError(sums, squares, means, references);
        square += e.square.low <= 0.02 / 1.01 && 0.02 / 1.01 <= e.square.high;
        bias += e.biasSquare.low <= 0.01 / 1.01 && 0.01 / 1.01 <= e.biasSquare.high;
    }
    EXPECT_GE(square, 88);
    EXPECT_GE(bias, 88);
}

TEST(TradeError, OfAnUnbiasedSettingHasNoBias) {
    std::mt19937 random(3);
    const References references{noisy(random, 0.05), noisy(random, 0.05)};
    const TrueError e = estimate(random, 8, 0.5, 1, references);
    EXPECT_LE(e.biasSquare.low, 0);
    EXPECT_LT(e.biasSquare.high, 0.01);
}

TEST(TradeError, OfImagesOfAnotherSizeIsRefused) {
    const References references{FilmImage(4, 4), FilmImage(4, 4)};
    EXPECT_THROW(squaredErrorOf(FilmImage(4, 5), references), Error);
}

TEST(TradeStudent, HasTheQuantilesOfTables) {
    /* Abramowitz and Stegun 1964, table 26.10 */
    EXPECT_NEAR(studentQuantile(1), 12.706, 0.001);
    EXPECT_NEAR(studentQuantile(7), 2.365, 0.001);
    EXPECT_NEAR(studentQuantile(7, 0.01), 3.499, 0.001);
    EXPECT_NEAR(studentQuantile(8, 0.001), 5.041, 0.001);
    EXPECT_NEAR(studentTail(-2.365, 7), 0.05, 1e-4);
}

/// A point of 8 seeds whose squared errors are `square`, and times 1, each times a factor near 1 that belongs to the seed; what belongs to
/// the render is a hundredth of that.
Point pairedPoint(std::mt19937& random, const std::vector<double>& ofSeeds, double square, double energy) {
    std::normal_distribution<double> own(0, 0.003);
    Point p;
    for (size_t i = 0; i < ofSeeds.size(); ++i)
        p.seeds.push_back({.seed = static_cast<int>(i) + 1,
                           .renderSeconds = std::exp(own(random)),
                           .meanSamples = 4,
                           .squaredError = square * std::exp(ofSeeds[i] + own(random)),
                           .mean = energy * std::exp(ofSeeds[i] + own(random))});
    return p;
}

TEST(TradePaired, IntervalsHoldTheRatioAndAreNarrow) {
    /* The seeds' factors, which scatter by 30 %, cancel: a gain of 5 % shows */
    std::mt19937 random(5);
    std::normal_distribution<double> factor(0, 0.3);
    int held = 0, energyHeld = 0, seen = 0, falseAlarms = 0;
    constexpr int trials = 200;
    for (int i = 0; i < trials; ++i) {
        std::vector<double> ofSeeds(8);
        for (double& f : ofSeeds) f = factor(random);
        const Point own = pairedPoint(random, ofSeeds, 0.04, 1), better = pairedPoint(random, ofSeeds, 0.04 / 1.05, 0.98),
                    same = pairedPoint(random, ofSeeds, 0.04, 1);
        const PairedDifference d = compareSeeds(own, better).value();
        held += d.efficiency.low <= 1.05 && 1.05 <= d.efficiency.high;
        energyHeld += d.energy.low <= -0.02 && -0.02 <= d.energy.high;
        seen += d.chanceOfEfficiency < 0.01;
        EXPECT_LT(d.efficiency.high - d.efficiency.low, 0.05);
        falseAlarms += compareSeeds(own, same).value().chanceOfEfficiency < 0.01;
    }
    /* 190 are expected; fewer than 180 would happen once in 500 times; more than 9 false alarms of 2, once in 10,000 times */
    EXPECT_GE(held, 180);
    EXPECT_GE(energyHeld, 180);
    EXPECT_EQ(seen, trials);
    EXPECT_LE(falseAlarms, 9);
}

TEST(TradePaired, NeedsFourSeedsAndErrorsAboveTheReferencesNoise) {
    std::mt19937 random(6);
    const Point few = pairedPoint(random, {0, 0, 0}, 0.04, 1), own = pairedPoint(random, std::vector<double>(8), 0.04, 1);
    EXPECT_FALSE(compareSeeds(own, few));
    EXPECT_FALSE(compareSeeds(own, pairedPoint(random, std::vector<double>(8), -0.001, 1)));
}

TEST(TradeError, ABiasIsSeenAndNoneIsNot) {
    std::mt19937 random(7);
    int seen = 0, falseAlarms = 0;
    for (int i = 0; i < 100; ++i) {
        const References references{noisy(random, 0.02), noisy(random, 0.02)};
        seen += estimate(random, 8, 0.3, 1.02, references).chanceOfBias < 0.01;
        falseAlarms += estimate(random, 8, 0.3, 1, references).chanceOfBias < 0.01;
    }
    /* 2 % of energy is 3 standard errors of 0.3 / sqrt(8 * 3072) and more */
    EXPECT_GE(seen, 95);
    EXPECT_LE(falseAlarms, 5);
}

MeasuredPoint pointAt(double samples, double bias, double slope, double secondsPerPath = 1e-6) {
    MeasuredPoint p;
    p.rung = p.samples = samples;
    p.secondsPerPath = secondsPerPath;
    p.error.variance = std::pow(samples, slope);
    p.error.biasSquare = {bias, bias * 0.9, bias * 1.1};
    p.error.square = {bias + p.error.variance, 0.9 * (bias + p.error.variance), 1.1 * (bias + p.error.variance)};
    return p;
}

TEST(TradeModel, FollowsAPowerOfTheSamplesToABias) {
    const std::vector<MeasuredPoint> points{pointAt(4, 0.01, -1.2), pointAt(16, 0.01, -1.2), pointAt(64, 0.01, -1.2),
                                            pointAt(256, 0.01, -1.2)};
    Setting biased, unbiased;
    biased.isBiased = true;
    const SettingModel m = fitModel(points, biased, 1e6, 2, 1.5);
    EXPECT_NEAR(m.slope.value, -1.2, 0.02);
    EXPECT_NEAR(m.error(256), std::sqrt(0.01 + std::pow(256, -1.2)), 0.002);
    EXPECT_NEAR(m.error(1e9), 0.1, 0.002) << "the bias stays";
    EXPECT_DOUBLE_EQ(m.seconds(100), 2 + 100 * 1e-6 * 1e6 * 1.5);
    EXPECT_FALSE(m.samplesForError(0.09)) << "below the bias";
    const SettingModel exact = fitModel(points, unbiased, 1e6, 2, 1.5);
    const double samples = exact.samplesForError(0.01).value();
    EXPECT_LE(exact.error(samples), 0.01);
    EXPECT_GE(exact.error(samples), 0.009) << "not a quarter more samples than that takes";
    EXPECT_LE(exact.seconds(exact.samplesInTime(30).value()), 30);
    EXPECT_FALSE(exact.samplesInTime(2.1)) << "one sample takes 3.5 seconds";
}

/// Thirteen points are three sets, of 8, 4 and 1: their mean has less noise than 13 independent points, but more than 13 of a line.
TEST(TradeModel, KnowsThatNumbersBetweenPowersOfTwoAreWorse) {
    const std::vector<MeasuredPoint> points{pointAt(4, 0, -1.5), pointAt(16, 0, -1.5), pointAt(64, 0, -1.5), pointAt(256, 0, -1.5)};
    Setting uniform, adaptive;
    adaptive.ladder = Ladder::targetErrors;
    const SettingModel m = fitModel(points, uniform, 1e6, 0, 1), mean = fitModel(points, adaptive, 1e6, 0, 1);
    ASSERT_LT(m.slope.value, -1.4);
    const double s = m.slope.value;
    EXPECT_NEAR(m.variance(13) / m.variance1, (std::pow(8, 2 + s) + std::pow(4, 2 + s) + 1) / 169, 1e-9);
    EXPECT_GT(m.variance(13), 1.4 * mean.variance(13));
    EXPECT_LT(m.variance(13), m.variance1 / 13);
    for (double n : {1., 2., 64., 1024.}) EXPECT_NEAR(m.variance(n), mean.variance(n), 1e-12) << n;
    EXPECT_EQ(m.samplesForError(m.error(16) * 1.001).value(), 16);
    EXPECT_EQ(m.samplesForError(mean.error(13.5)).value(), 16) << "14 and 15 samples are worse than 16";
}

TEST(TradeModel, RecommendsTheFastBiasedSettingForLargeErrorsAndTheUnbiasedOneForSmall) {
    std::vector<Setting> settings(2);
    settings[1].isBiased = true;
    std::vector<MeasuredPoint> slow{pointAt(4, 0, -1, 1e-6), pointAt(64, 0, -1, 1e-6)},
        fast{pointAt(4, 0.0025, -1, 2e-7), pointAt(64, 0.0025, -1, 2e-7)};
    for (MeasuredPoint& p : fast) p.setting = 1;
    const std::vector<SettingModel> models{fitModel(slow, settings[0], 1e6, 0.5, 1), fitModel(fast, settings[1], 1e6, 0.5, 1)};
    const auto chosen = [&](Wish::Kind kind, double value) { return recommend({kind, value}, models, settings); };
    EXPECT_EQ(chosen(Wish::Kind::error, 0.2).setting, 1u);
    EXPECT_EQ(chosen(Wish::Kind::error, 0.02).setting, 0u);
    EXPECT_EQ(chosen(Wish::Kind::seconds, 5).setting, 1u);
    EXPECT_EQ(chosen(Wish::Kind::seconds, 3000).setting, 0u);
    EXPECT_FALSE(chosen(Wish::Kind::seconds, 0.6).isPossible) << "a sample of the fast one takes 0.2 s after 0.5 s";
    EXPECT_LE(chosen(Wish::Kind::error, 0.02).error, 0.0201);
}

TEST(TradeModel, PrefersWhatIsKnownToWhatIsExtrapolatedFar) {
    std::vector<Setting> settings(2);
    std::vector<MeasuredPoint> known{pointAt(4, 0, -1), pointAt(16, 0, -1), pointAt(64, 0, -1)}, glimpsed{pointAt(4, 0, -1, 9e-7)};
    glimpsed[0].setting = 1;
    const std::vector<SettingModel> models{fitModel(known, settings[0], 1e6, 0, 1), fitModel(glimpsed, settings[1], 1e6, 0, 1)};
    EXPECT_GT(models[1].uncertaintyAt(4096), 3 * models[0].uncertaintyAt(4096));
    EXPECT_EQ(recommend({Wish::Kind::error, 0.015}, models, settings).setting, 0u);
    EXPECT_EQ(recommend({Wish::Kind::seconds, 4000}, models, settings).setting, 0u);
}

TEST(TradeModel, TheFrontHasWhatNothingElseBeats) {
    std::vector<MeasuredPoint> points(3);
    const double seconds[] = {1, 2, 3}, squares[] = {0.04, 0.09, 0.01};
    for (size_t i = 0; i < 3; ++i) {
        points[i].seconds = seconds[i];
        points[i].error.square.value = squares[i];
    }
    markFront(points);
    EXPECT_TRUE(points[0].isOnFront && !points[1].isOnFront && points[2].isOnFront);
}

TEST(TradeOptions, OfASettingReplaceTheUsers) {
    EXPECT_THAT(overridden({"--max-depth=5", "--seed=3"}, {"--max-depth=1", "--spp=4"}),
                testing::ElementsAre("--seed=3", "--max-depth=1", "--spp=4"));
}

TEST(TradeOptions, WishesAreTimesOrErrors) {
    EXPECT_EQ(parseWish("--for", "2m"), (Wish{Wish::Kind::seconds, 120}));
    EXPECT_EQ(parseWish("--for", "0.5%"), (Wish{Wish::Kind::error, 0.005}));
    EXPECT_EQ(parseDuration("--budget", "1.5h"), 5400);
    for (const char* text : {"", "s", "%", "-3s", "0%", "2 %x", "1d", "nan", "inf"})
        EXPECT_THROW(parseWish("--for", text), UsageError) << text;
}

class TradeState : public TemporaryFolder {};

TEST_F(TradeState, GoesOnOnlyWithWhatItBelongsTo) {
    const std::string file = path("study.json");
    StudyState state;
    state.scene = "a.pbrt";
    state.sceneHash = "1";
    state.baseOptions = {"--max-depth=3"};
    state.settings = {{"as given", "", {}}, {"depth", "1", {"--max-depth=1"}, true, true}};
    state.points = {{.setting = 1, .rung = 4, .seeds = {{1, 0.5, 4, 0.1, 0.2, 0.3}}}};
    state.referenceSamples = 64;
    state.save(file);
    const StudyState loaded = StudyState::load(file, state).value();
    EXPECT_EQ(loaded.settings[1].options, state.settings[1].options);
    EXPECT_EQ(loaded.points[0].seeds[0].squaredError, 0.2);
    EXPECT_EQ(loaded.ladderOf(1).size(), 1u);
    StudyState other = state;
    other.sceneHash = "2";
    try {
        StudyState::load(file, other);
        FAIL() << "another scene";
    } catch (const Error& error) { EXPECT_THAT(error.what(), testing::HasSubstr("content has changed")); }
    EXPECT_FALSE(StudyState::load(path("none.json"), state));
}

TEST(TradeReport, PlotsAreValidWhateverTheyShow) {
    Plot plot{.xLabel = "x < y & z",
              .yLabel = "y",
              .curves = {{"c", "red", {{1, 2, 1, 3, "\"a\""}, {-1, 2}, {NAN, 1}, {10, 0.1}}}},
              .front = {{1, 2}}};
    const std::string svg = asSvg(plot);
    EXPECT_THAT(svg, testing::HasSubstr("x &lt; y &amp; z"));
    EXPECT_THAT(svg, testing::Not(testing::HasSubstr("nan")));
    EXPECT_EQ(std::count(svg.begin(), svg.end(), '<'), std::count(svg.begin(), svg.end(), '>'));
    EXPECT_THAT(asSvg({}), testing::HasSubstr("</svg>")) << "nothing measured";
}

}  // namespace
}  // namespace eikonal
