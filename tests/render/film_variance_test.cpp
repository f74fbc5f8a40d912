// The variance of a pixel is that of what the pixel shows: a mean over the weights of a filter, which may be negative.

#include "rendering.h"

#include <algorithm>

namespace eikonal {
namespace {

/// Pixels that see much of a sky, and the edge of a black ball in it.
View wide(const std::string& filter, int seed, int size = 16) {
    View view;
    view.width = view.height = size;
    view.fov = 60;
    view.samples = 64;
    view.more = "PixelFilter \"" + filter + "\"\nOption \"seed\" " + std::to_string(seed) + "\n";
    return view;
}

// Under an even sky the sum of weighted samples is as uncertain as the sum of weights, and their quotient is not uncertain at all.
TEST(FilmVariance, OfAnEvenSkyIsZeroWhateverTheFilter) {
    for (const char* filter : {"box", "gaussian", "mitchell", "sinc"}) {
        const Rendered r = render(sceneText(wide(filter, 0), "LightSource \"infinite\" \"rgb L\" [.3 .3 .3]"), surfaces());
        EXPECT_LT(*std::max_element(r.image.variance.begin(), r.image.variance.end()), 1e-12) << filter;
    }
}

// The squared difference of two images with other seeds has the expectation of the sum of both variances. Some 250 pixels at the edge of
// the ball in each of two pairs: their mean is known to about 6 %.
TEST(FilmVariance, IsHowMuchSeedsDiffer) {
    for (const char* filter : {"box", "mitchell"}) {
        constexpr int pairs = 2;
        double expected = 0, found = 0;
        for (int i = 0; i < pairs; ++i) {
            const auto image = [&](int seed) {
                return render(sceneText(wide(filter, seed, 128),
                                        "LightSource \"infinite\" \"rgb L\" [1 1 1]\nMaterial \"diffuse\" \"rgb reflectance\" [0 0 "
                                        "0]\nShape \"sphere\""),
                              surfaces())
                    .image;
            };
            const FilmImage a = image(2 * i), b = image(2 * i + 1);
            for (size_t p = 0; p < a.pixelCount(); ++p) {
                expected += a.variance[p] + b.variance[p];
                const double difference = a.color[p].g - b.color[p].g;
                found += difference * difference;
            }
        }
        EXPECT_NEAR(found / expected, 1, 0.25) << filter;
    }
}

}  // namespace
}  // namespace eikonal
