#pragma once
// The channels of a multi-channel file, and the numbers of a FilmImage that they hold.

#include "image/film_image.h"
#include "image/spectral_layout.h"

#include <string>
#include <type_traits>
#include <vector>

namespace eikonal {

/// The depth that is stored where no surface was hit.
constexpr float noDepth = 1e10f;

/// One channel: value i belongs to pixel i. Float is `float`, or `const float` to read only.
template <class Float> struct ChannelView {
    std::string name;
    Float* first;
    std::size_t stride;
    bool isDepth = false;
    bool needsFloats = false;   ///< positions, numbers and counts, of which 16 bits hold too little
    Float& operator[](std::size_t i) const { return first[i * stride]; }
};

/// The channels that the image has, colour first. The image must outlive them.
template <class Float, class Image> std::vector<ChannelView<Float>> channelsOf(Image& image) {
    std::vector<ChannelView<Float>> channels;
    const auto add3 = [&](auto& values, const char* x, const char* y, const char* z, bool needsFloats = false) {
        int c = 0;
        if (!values.empty()) for (const char* name : {x, y, z}) channels.push_back({name, &values[0][c++], 3, false, needsFloats});
    };
    const auto add2 = [&](auto& values, const char* x, const char* y) {
        int c = 0;
        if (!values.empty()) for (const char* name : {x, y}) channels.push_back({name, &values[0][c++], 2, false, true});
    };
    const auto add1 = [&](auto& values, const char* name) {
        if (!values.empty()) channels.push_back({name, values.data(), 1, false, true});
    };
    add3(image.color, "R", "G", "B");
    add3(image.noisy, "noisy.R", "noisy.G", "noisy.B");
    add3(image.albedo, "albedo.R", "albedo.G", "albedo.B");
    add3(image.normal, "N.X", "N.Y", "N.Z");
    add3(image.geometricNormal, "Ng.X", "Ng.Y", "Ng.Z");
    add3(image.position, "P.X", "P.Y", "P.Z", true);
    add2(image.uv, "u", "v");
    add2(image.depthSlope, "dzdx", "dzdy");
    add2(image.motion, "motion.X", "motion.Y");
    if (!image.depth.empty()) channels.push_back({"Z", image.depth.data(), 1, true, true});
    add1(image.object, "objectId");
    add1(image.material, "materialId");
    add1(image.variance, "variance");
    add1(image.sampleCount, "sampleCount");
    const auto& wavelengths = image.spectrum.wavelengths;
    for (std::size_t b = 0; b < wavelengths.size(); ++b)
        channels.push_back({bucketChannel(wavelengths[b]), &image.spectrum.radiance[b], wavelengths.size()});
    return channels;
}

}  // namespace eikonal
