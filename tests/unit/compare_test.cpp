// The numbers by which images are compared.

#include "image/compare.h"

#include "error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace eikonal {
namespace {

FilmImage flat(int width, int height, glm::vec3 color) {
    FilmImage image(width, height);
    std::fill(image.color.begin(), image.color.end(), color);
    return image;
}

TEST(Compare, equalImagesAgree) {
    const FilmImage image = flat(20, 12, {.5f, 0, 2});
    const Comparison result = compare(image, image);
    EXPECT_EQ(result.relativeMse, 0);
    EXPECT_EQ(result.worstMean(), 0);
    EXPECT_EQ(result.invalid, 0);
    ASSERT_EQ(result.blocks.size(), 6u);  // 3 x 2 blocks, the last of 4 x 4 pixels
    EXPECT_EQ(result.blocks[5].x, 16);
    EXPECT_EQ(result.blocks[5].y, 8);
    EXPECT_EQ(result.worstBlock(0, 0).distance(0, 0), 0);
}

// A firefly, in 60 x 50 pixels, of which 3 count as the worst
TEST(Compare, theTrimmedErrorIsThatOfMostPixels) {
    const FilmImage reference = flat(60, 50, {1, 1, 1});
    FilmImage image = flat(60, 50, {1.1f, 1.1f, 1.1f});
    image.color[77] = {1001, 1001, 1001};
    const Comparison result = compare(image, reference);
    EXPECT_NEAR(result.relativeMse, (1e6 + 2999 * .01) / 1.01 / 3000, 1e-4);
    EXPECT_NEAR(result.trimmedRelativeMse, .01 / 1.01, 1e-8);
    EXPECT_GT(compare(flat(1, 1, {2, 1, 1}), flat(1, 1, {1, 1, 1})).trimmedRelativeMse, 0);
}

TEST(Compare, meansAndRelativeMse) {
    const Comparison result = compare(flat(8, 8, {1.02f, .5f, .5f}), flat(8, 8, {1, .5f, .5f}));
    EXPECT_NEAR(result.mean.x, 1.02, 1e-6);
    EXPECT_NEAR(result.worstMean(), .02, 1e-6);
    // The mean of the reference is 2/3; one channel of three is off.
    EXPECT_NEAR(result.relativeMse, .0004 / (1 + .01 * 4 / 9) / 3, 1e-8);
    // As far off when both are a thousand times as bright
    EXPECT_NEAR(compare(flat(8, 8, {1020, 500, 500}), flat(8, 8, {1000, 500, 500})).relativeMse, result.relativeMse, 1e-8);
    EXPECT_TRUE(std::isinf(compare(flat(1, 1, {0, 1, 0}), flat(1, 1, {0, 0, 0})).worstMean()));
}

TEST(Compare, findsTheBlockThatIsOff) {
    FilmImage image = flat(32, 32, glm::vec3(1)), reference = image;
    for (int y = 8; y < 16; ++y)
        for (int x = 16; x < 24; ++x) image.color[image.index(x, y)].y = 1.1f;
    const Comparison result = compare(image, reference);
    const BlockDifference& worst = result.worstBlock(.05, 4);
    EXPECT_EQ(worst.x, 16);
    EXPECT_EQ(worst.y, 8);
    EXPECT_NEAR(worst.distance(.05, 4), 2, 5e-3);  // off by 0.1, the same in every pixel, 0.05 of it allowed
}

TEST(Compare, theStandardErrorIsThatOfTheMeanOfABlock) {
    // Differences are uniform in [-1, 1]: standard deviation 1/sqrt(3), so 1/sqrt(3 * 64) = 0.0722 for the mean of 64.
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(-1, 1);
    FilmImage image = flat(256, 256, glm::vec3(5)), reference = image;
    for (glm::vec3& color : image.color) color.x += uniform(random);
    double sum = 0, squares = 0;
    const Comparison result = compare(image, reference);
    for (const BlockDifference& block : result.blocks) {
        sum += block.standardError.x / static_cast<double>(result.blocks.size());
        squares += std::pow((block.image.x - block.reference.x) / block.standardError.x, 2) / static_cast<double>(result.blocks.size());
        EXPECT_EQ(block.standardError.y, 0);
    }
    EXPECT_NEAR(sum, .0722, .002);
    EXPECT_NEAR(squares, 1, .15);  // blocks scatter by as much as their standard errors say; 1024 blocks: 1 +- 0.05
    EXPECT_LE(result.worstBlock(0, 6).distance(0, 6), 1);
}

TEST(Compare, theStandardErrorIsThatOfTheVariancesWhereTheImageHasThem) {
    // 64 pixels, each known to 0.1 in luminance: their mean to 0.1 / 8, and that less another such mean to sqrt(2) of it.
    FilmImage image = flat(8, 8, {2, 1, .5f}), reference = image;
    for (int i = 0; i < 64; i += 2) image.color[i] *= 1.2f, image.color[i + 1] *= .8f;  // scatter that the variances do not know of
    image.variance.assign(64, .01f);
    const double luminance = 2 * .2126 + .7152 + .5 * .0722, expected = .1 / 8 * std::sqrt(2) / luminance;
    const BlockDifference known = compare(image, reference).blocks[0];
    EXPECT_NEAR(known.standardError.x, 2 * expected, 1e-6);
    EXPECT_NEAR(known.standardError.z, .5 * expected, 1e-6);
    reference.variance.assign(64, .03f);  // 0.01 + 0.03 is twice 0.01 + 0.01
    EXPECT_NEAR(compare(image, reference).blocks[0].standardError.y, std::sqrt(2) * expected, 1e-6);
}

// A sample that is hit once in a million in the dark makes no block differ, though it is off by all of it.
TEST(Compare, forgivesWhatIsNegligibleBesideTheRest) {
    FilmImage image = flat(16, 8, glm::vec3(1)), reference = image;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) image.color[image.index(x, y)] = glm::vec3(0), reference.color[image.index(x, y)] = glm::vec3(2e-5f);
    EXPECT_LE(compare(image, reference).worstBlock(.05, 4).distance(.05, 4), .5);
}

TEST(Compare, leavesOutWhatIsNotFinite) {
    FilmImage image = flat(8, 8, glm::vec3(1)), reference = image;
    image.color[3].x = std::numeric_limits<float>::quiet_NaN();
    reference.color[9].y = std::numeric_limits<float>::infinity();
    const Comparison result = compare(image, reference);
    EXPECT_EQ(result.invalid, 2);
    EXPECT_EQ(result.relativeMse, 0);
    EXPECT_EQ(result.mean, glm::dvec3(1));
    for (glm::vec3& color : image.color) color.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(compare(image, reference), Error);
}

TEST(Compare, comparesACropWithItsPlaceInTheWhole) {
    FilmImage whole(16, 16);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) whole.color[whole.index(x, y)] = {x, y, 1};
    FilmImage crop(16, 16, {5, 9, 3, 6});
    for (int y = 3; y < 6; ++y)
        for (int x = 5; x < 9; ++x) crop.color[crop.index(x, y)] = {x, y, 1};
    EXPECT_EQ(compare(crop, whole).relativeMse, 0);
    EXPECT_THAT(
        [&] {
            compare(crop, FilmImage(16, 16, {0, 5, 0, 3}));
        },
        testing::ThrowsMessage<Error>("the images have no pixel in common"));
    EXPECT_THAT([&] { compare(crop, FilmImage(8, 16)); },
                testing::ThrowsMessage<Error>("images of 16 x 16 and 8 x 16 pixels cannot be compared"));
}

}  // namespace
}  // namespace eikonal
