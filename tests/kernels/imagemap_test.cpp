// Images as textures against double precision: in every format, wrap and filter.

#include "random_inputs.h"
#include "texture_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace eikonal {
namespace {

double decode(double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); }

struct ImageCase { uint width, height, channels; image_format format; image_wrap wrap; image_filter filter; std::vector<float> texels; };

double texelOf(const ImageCase& c, int x, int y, uint channel) {
    const int w = static_cast<int>(c.width), h = static_cast<int>(c.height);
    if (c.wrap == wrap_black && (x < 0 || y < 0 || x >= w || y >= h)) return 0;
    if (c.wrap == wrap_clamp) { x = std::clamp(x, 0, w - 1); y = std::clamp(y, 0, h - 1); }
    x = ((x % w) + w) % w; y = ((y % h) + h) % h;
    const float t = c.texels[static_cast<size_t>(y * w + x) * c.channels + (c.channels == 1 ? 0 : channel)];
    const double stored = c.format == format_float ? static_cast<double>(t) : std::lround(t * 255) / 255.0;
    return c.format == format_srgb8 ? decode(stored) : stored;
}

/// (s, t) = (0, 0) is the lower left corner; texel centres lie at half-integers.
double lookUp(const ImageCase& c, double s, double t, uint channel) {
    double x = s * c.width, y = (1 - t) * c.height;
    if (c.filter == filter_nearest) return texelOf(c, static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)), channel);
    x -= 0.5; y -= 0.5;
    const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
    const double fx = x - ix, fy = y - iy;
    return (1 - fy) * ((1 - fx) * texelOf(c, ix, iy, channel) + fx * texelOf(c, ix + 1, iy, channel)) +
           fy * ((1 - fx) * texelOf(c, ix, iy + 1, channel) + fx * texelOf(c, ix + 1, iy + 1, channel));
}

/// Every format, number of channels, wrap mode and filter, well inside of the image and far outside.
TEST(Imagemap, IsWhatTheImageSays) {
    Textures textures;
    Random random(80);
    std::vector<ImageCase> cases;
    for (image_format format : {format_srgb8, format_linear8, format_float})
        for (uint channels : {1u, 3u, 4u})
            for (image_wrap wrap : {wrap_repeat, wrap_black, wrap_clamp})
                for (image_filter filter : {filter_nearest, filter_bilinear}) {
                    ImageCase c{5, 3, channels, format, wrap, filter, generate(15 * channels, [&] { return random.unit(); })};
                    textures.program({textures.lookup(textures.image(c.width, c.height, channels, format, wrap, filter, c.texels))});
                    cases.push_back(c);
                }
    std::vector<uint> program;
    std::vector<vec2> uv;
    for (uint k = 0; k < cases.size(); ++k)
        for (int i = 0; i < 400; ++i) {
            program.push_back(k);
            uv.push_back(i % 4 ? random.square() : vec2{random.between(-3, 3), random.between(-3, 3)});
        }
    const auto results = evaluate(textures.scene, program, uv, std::vector<vec3>(uv.size()));
    for (size_t i = 0; i < results.size(); ++i) {
        const ImageCase& c = cases[program[i]];
        const double x = static_cast<double>(uv[i].x) * c.width, y = (1 - static_cast<double>(uv[i].y)) * c.height;
        if (c.filter == filter_nearest && (std::abs(x - std::round(x)) < 1e-5 || std::abs(y - std::round(y)) < 1e-5)) continue;
        const float got[3] = {results[i].value.r, results[i].value.g, results[i].value.b};
        for (uint channel = 0; channel < 3; ++channel)
            ASSERT_NEAR(got[channel], lookUp(c, uv[i].x, uv[i].y, channel), 2e-5)
                << "format " << c.format << " channels " << c.channels << " wrap " << c.wrap << " filter " << c.filter << " at " << uv[i].x
                << " " << uv[i].y;
    }
}

/// The octahedral wrap folds each edge onto itself: just outside of it lies what is just inside, mirrored along the edge.
TEST(Imagemap, OctahedralEdgesFoldOntoThemselves) {
    Textures textures;
    Random random(81);
    textures.program({textures.lookup(
        textures.image(8, 8, 3, format_float, wrap_octahedral, filter_bilinear, generate(8 * 8 * 3, [&] { return random.unit(); })))});
    std::vector<vec2> out, in;
    for (int i = 0; i < 500; ++i) {
        const float s = random.between(0.1f, 0.9f), e = random.between(0, 0.06f);
        const std::array<std::pair<vec2, vec2>, 4> edges{
            {{{s, -e}, {1 - s, e}}, {{s, 1 + e}, {1 - s, 1 - e}}, {{-e, s}, {e, 1 - s}}, {{1 + e, s}, {1 - e, 1 - s}}}};
        out.push_back(edges[static_cast<size_t>(i % 4)].first);
        in.push_back(edges[static_cast<size_t>(i % 4)].second);
    }
    const std::vector<uint> program(out.size(), 0);
    const std::vector<vec3> p(out.size());
    const auto a = evaluate(textures.scene, program, out, p), b = evaluate(textures.scene, program, in, p);
    for (size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i].value.g, b[i].value.g, 1e-5) << out[i].x << " " << out[i].y;
}

}  // namespace
}  // namespace eikonal
