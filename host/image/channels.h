#pragma once
// The channels of a multi-channel file, and the numbers of a FilmImage that they hold.

#include "image/film_image.h"
#include "image/image_encoding.h"
#include "image/spectral_layout.h"

#include <array>
#include <string>
#include <vector>

namespace eikonal {

/// The depth that is stored where no surface was hit.
constexpr float noDepth = 1e10f;

/// What the numbers of a channel are.
struct ChannelUse {
    bool needsFloats = false;  ///< positions, numbers and counts, of which 16 bits hold too little
    bool isDepth = false;
    bool isBits = false;       ///< IDs, which every change of a bit makes wrong
};

/// One channel: value i belongs to pixel i. Float is `float`, or `const float` to read only.
template <class Float>
struct ChannelView {
    std::string name;
    Float* first;
    std::size_t stride;
    ChannelUse use;
    Float& operator[](std::size_t i) const { return first[i * stride]; }
};

/// The layer of a light group is called like it: "light_key.R".
inline constexpr const char* lightGroupPrefix = "light_";
inline std::string lightGroupChannel(const std::string& group, std::size_t component) {
    return lightGroupPrefix + group + '.' + "RGB"[component];
}

/// The names of the components of a vector of FilmImage; the rest is null.
using ComponentNames = std::array<const char*, 3>;

/// Calls visit(vector, names, use) for each vector of the image that a file may have, colour first; those without a name in this spelling
/// are left out. The names follow the layers of Blender and Nuke and the guides of OIDN, or pbrt-v4's film "gbuffer".
template <class Image, class Visit>
void forChannels(Image& image, ChannelNames spelling, Visit visit) {
    const bool isPbrt = spelling == ChannelNames::pbrt;
    const auto spelled = [&](const ComponentNames& ours, const ComponentNames& pbrts) { return isPbrt ? pbrts : ours; };
    const ChannelUse few{}, exact{.needsFloats = true};
    visit(image.color, ComponentNames{"R", "G", "B"}, few);
    visit(image.noisy, ComponentNames{"noisy.R", "noisy.G", "noisy.B"}, few);
    visit(image.fireflies, ComponentNames{"fireflies.R", "fireflies.G", "fireflies.B"}, few);
    visit(image.emission, ComponentNames{"emission.R", "emission.G", "emission.B"}, few);
    visit(image.direct, ComponentNames{"direct.R", "direct.G", "direct.B"}, few);
    visit(image.indirect, ComponentNames{"indirect.R", "indirect.G", "indirect.B"}, few);
    visit(image.volume, ComponentNames{"volume.R", "volume.G", "volume.B"}, few);
    visit(image.albedo, spelled({"albedo.R", "albedo.G", "albedo.B"}, {"Albedo.R", "Albedo.G", "Albedo.B"}), few);
    visit(image.normal, spelled({"N.X", "N.Y", "N.Z"}, {"Ns.X", "Ns.Y", "Ns.Z"}), few);
    visit(image.geometricNormal, spelled({"Ng.X", "Ng.Y", "Ng.Z"}, {"N.X", "N.Y", "N.Z"}), few);
    visit(image.position, ComponentNames{"P.X", "P.Y", "P.Z"}, exact);
    visit(image.uv, ComponentNames{"u", "v"}, exact);
    visit(image.depthSlope, ComponentNames{"dzdx", "dzdy"}, exact);
    visit(image.motion, ComponentNames{"motion.X", "motion.Y"}, exact);
    visit(image.depth, ComponentNames{"Z"}, ChannelUse{.needsFloats = true, .isDepth = true});
    visit(image.object, ComponentNames{"objectId"}, exact);
    visit(image.material, ComponentNames{"materialId"}, exact);
    if (!isPbrt) visit(image.variance, ComponentNames{"variance"}, exact);
    if (isPbrt) visit(image.sampleVariance, ComponentNames{"Variance.R", "Variance.G", "Variance.B"}, exact);
    if (isPbrt) visit(image.relativeVariance, ComponentNames{"RelativeVariance.R", "RelativeVariance.G", "RelativeVariance.B"}, exact);
    visit(image.sampleCount, ComponentNames{"sampleCount"}, exact);
}

/// The channels that the image has, colour first. The image must outlive them.
template <class Float, class Image>
std::vector<ChannelView<Float>> channelsOf(Image& image, ChannelNames spelling = ChannelNames::eikonal) {
    std::vector<ChannelView<Float>> channels;
    forChannels(image, spelling, [&](auto& values, const ComponentNames& names, ChannelUse use) {
        if (values.empty()) return;
        constexpr std::size_t components = sizeof values[0] / sizeof(float);
        auto* first = reinterpret_cast<Float*>(values.data());
        for (std::size_t c = 0; c < components; ++c) channels.push_back({names[c], first + c, components, use});
    });
    for (auto& group : image.lightGroups)
        for (std::size_t c = 0; c < 3; ++c)
            channels.push_back({lightGroupChannel(group.name, c), reinterpret_cast<Float*>(group.color.data()) + c, 3, {}});
    for (auto& layer : image.cryptomattes)
        for (std::size_t i = 0; i < CryptomatteLayer::perPixel; ++i)
            channels.push_back({cryptomatteChannel(layer.name, i), &layer.values[i], CryptomatteLayer::perPixel,
                                {.needsFloats = true, .isBits = true}});
    const auto& wavelengths = image.spectrum.wavelengths;
    for (std::size_t b = 0; b < wavelengths.size(); ++b)
        channels.push_back({bucketChannel(wavelengths[b]), &image.spectrum.radiance[b], wavelengths.size(), {}});
    return channels;
}

}  // namespace eikonal
