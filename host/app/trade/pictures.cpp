#include "app/trade/pictures.h"

#include "color/luminance.h"
#include "image/encode_png.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace eikonal {
namespace {

std::string base64(const std::vector<unsigned char>& bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const size_t present = std::min<size_t>(3, bytes.size() - i);
        std::uint32_t word = 0;
        for (size_t k = 0; k < 3; ++k) word = word << 8 | (k < present ? bytes[i + k] : 0u);
        for (size_t k = 0; k < 4; ++k) text += k <= present ? digits[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

/// `color(i)`: the stored values of pixel i, in [0, 1].
template <class F>
std::string asPng(const FilmImage& size, F&& color) {
    EncodedImage png;
    png.stored = EncodedImage::Values::bytes;
    png.width = png.fullWidth = size.columns();
    png.height = png.fullHeight = size.rows();
    png.channels = {"R", "G", "B"};
    for (size_t i = 0; i < size.pixelCount(); ++i) {
        const glm::vec3 c = color(i);
        png.values.insert(png.values.end(), {c.x, c.y, c.z});
    }
    return "data:image/png;base64," + base64(encodePng(png));
}

}  // namespace

double exposureFor(double mean) {
    constexpr double darkest = 0.05, brightest = 0.8, usual = 0.3;
    return mean >= darkest && mean <= brightest ? 0 : std::log2(usual / mean);
}

std::string picture(const FilmImage& image, const ToneMapping& mapping) {
    return asPng(image, [&](size_t i) { return toneMap(image.color[i], mapping); });
}

std::string storedPicture(const FilmImage& image) {
    return asPng(image, [&](size_t i) { return image.color[i]; });
}

std::string differencePicture(const FilmImage& image, const FilmImage& reference, double range) {
    double mean = 0;
    for (const glm::vec3& c : reference.color) mean += luminance(c) / static_cast<double>(reference.color.size());
    return asPng(image, [&](size_t i) {
        const double expected = luminance(reference.color[i]), difference = luminance(image.color[i]) - expected;
        const double t = std::clamp(difference / (std::abs(expected) + 0.1 * mean) / range, -1., 1.);
        const float strength = static_cast<float>(std::sqrt(std::abs(t)));
        const glm::vec3 grey(0.88f), full = t > 0 ? glm::vec3(0.75f, 0.05f, 0.1f) : glm::vec3(0.05f, 0.2f, 0.75f);
        return std::isfinite(t) ? grey + (full - grey) * strength : glm::vec3(0);
    });
}

}  // namespace eikonal
