// Aperture shapes: pbrt-v4's built-in ones, and images.

#include "pack/lens.h"
#include "image/image_data.h"

#include <cmath>

namespace eikonal {

constexpr int resolution = 256;

/// Whether (x, y) is inside the polygon: its winding number is not 0.
static bool isInside(const std::vector<glm::dvec2>& corners, double x, double y) {
    int turns = 0;
    for (size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
        const double side = (x - a.x) * (b.y - a.y) - (y - a.y) * (b.x - a.x);
        if (a.y <= y && b.y > y && side > 0) ++turns;
        if (a.y > y && b.y <= y && side < 0) --turns;
    }
    return turns != 0;
}

/// Transmission at (x, y) in [-1, 1]^2, y up.
static double eval(ApertureShape shape, const std::vector<glm::dvec2>& corners, double x, double y) {
    switch (shape) {
        case ApertureShape::gaussian: return std::max(0.0, std::exp(-(x * x + y * y)) - std::exp(-1.0));
        case ApertureShape::square: return std::max(std::abs(x), std::abs(y)) < 0.5;
        default: return isInside(corners, x, y);
    }
}

/// Corners of the polygons; none for other shapes. pbrt-v4 flips its images vertically, so these are upside down.
static std::vector<glm::dvec2> cornersOf(ApertureShape shape) {
    std::vector<glm::dvec2> corners;
    const double inner = std::cos(2 * M_PI / 5) / std::cos(M_PI / 5);
    if (shape == ApertureShape::pentagon)
        for (int i = 0; i < 5; ++i) corners.push_back(0.8 * glm::dvec2(std::sin(2 * M_PI * i / 5), -std::cos(2 * M_PI * i / 5)));
    if (shape == ApertureShape::star)
        for (int i = 0; i < 10; ++i) corners.push_back((i % 2 ? 1.0 : inner) * glm::dvec2(std::cos(M_PI * i / 5), -std::sin(M_PI * i / 5)));
    return corners;
}

ApertureTexels apertureTexels(ApertureShape shape, const ImageData* image) {
    ApertureTexels texels;
    if (shape == ApertureShape::round) return texels;
    texels.width = image ? image->width : resolution;
    texels.height = image ? image->height : resolution;
    const std::vector<glm::dvec2> corners = cornersOf(shape);
    double sum = 0;
    for (int row = 0; row < texels.height; ++row)
        for (int column = 0; column < texels.width; ++column) {
            double value = 0;
            if (image) {
                const int channels = image->channels < 3 ? 1 : 3;
                for (int c = 0; c < channels; ++c) value += static_cast<double>(image->at(column, texels.height - 1 - row, c)) / channels;
            } else value = eval(shape, corners, -1 + 2 * (column + 0.5) / resolution, -1 + 2 * (row + 0.5) / resolution);
            texels.values.push_back(static_cast<float>(value));
            sum += value;
        }
    if (!(sum > 0)) throw Error(ExitCode::scene, "the image of the aperture is black, so it blocks all light");
    const double scale = M_PI / 4 * texels.width * texels.height / sum;
    for (float& v : texels.values) v = static_cast<float>(v * scale);
    return texels;
}

}  // namespace eikonal
