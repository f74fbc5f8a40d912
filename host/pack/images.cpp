// The images that textures read.

#include "color/luminance.h"
#include "color/transfer.h"
#include "pack/textures.h"
#include "read/formats/image.h"

#include <algorithm>
#include <cstring>

namespace eikonal {

static uint packBytes(Table<uint>& table, const std::vector<std::uint8_t>& bytes) {
    const size_t first = table.size() * 4;
    table.resize(table.size() + (bytes.size() + 3) / 4);
    if (!bytes.empty()) std::memcpy(reinterpret_cast<std::uint8_t*>(table.data()) + first, bytes.data(), bytes.size());
    return static_cast<uint>(first);
}

uint TexturePacker::image(int index, bool asFloat) {
    const auto [found, isNew] = images_.try_emplace({index, asFloat}, 0);
    if (!isNew) return found->second;
    const ImageFile& file = context_.scene.images[static_cast<size_t>(index)];
    const ImageData& original = context_.imageData(index);
    const ImageData& data = asFloat && original.channels > 1 ? scalarImage(original) : original;

    eikonal::image im{};
    im.width = static_cast<uint>(data.width);
    im.height = static_cast<uint>(data.height);
    im.channels = static_cast<uint>(data.channels);
    im.format = data.format;
    im.wrap = file.wrap;
    im.filter = file.filter;
    if (data.format == format_float) {
        im.first = static_cast<uint>(tables_.float_texels.size());
        tables_.float_texels.insert(tables_.float_texels.end(), data.floats.begin(), data.floats.end());
    } else im.first = packBytes(tables_.byte_texels, data.bytes);
    if (im.format == format_srgb8 && tables_.srgb_levels.empty())
        tables_.srgb_levels.assign(linearFromSrgbByte().begin(), linearFromSrgbByte().end());
    found->second = static_cast<uint>(tables_.images.size());
    tables_.images.push_back(im);
    return found->second;
}

double TexturePacker::meanLuminance(int index) {
    const auto [found, isNew] = meanLuminances_.try_emplace(index, 0);
    if (!isNew) return found->second;
    const ImageData& image = context_.imageData(index);
    glm::dvec3 sum(0);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c) sum[c] += std::max(image.at(x, y, image.channels == 1 ? 0 : c), 0.0f);
    return found->second = luminance(sum) / (static_cast<double>(image.width) * image.height);
}

}  // namespace eikonal
