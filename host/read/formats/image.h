#pragma once
// Texels: image files as textures and environments read them.

#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace eikonal {

enum class TexelFormat { srgb8, linear8, float32 };

/// A decoded image. Row 0 is the top; channels are interleaved: texel (x, y) begins at channels (y width + x).
struct ImageData {
    int width = 0, height = 0;
    int channels = 1;                    ///< 1: grey, 3: R G B, 4: R G B and alpha, not multiplied in
    TexelFormat format = TexelFormat::float32;  ///< how the values are stored; alpha is stored like the colours, as in pbrt-v4
    std::vector<std::uint8_t> bytes;     ///< srgb8 and linear8
    std::vector<float> floats;           ///< float32: linear sRGB
    std::size_t replaced = 0;            ///< values of the file that were not finite: NaN became 0, infinity 65504 (the largest half)

    /// The linear value of a channel; 0 <= x < width, 0 <= y < height.
    float at(int x, int y, int channel) const;
};

/// Reads an image file, of any format that OpenImageIO knows.
/// - 8-bit files stay 8-bit (unless `gamma` is given), all others become floats.
/// - Encoding: sRGB for integers and linear for floats, as pbrt-v4; `encoding` and `gamma` apply to integers only.
/// - Channels R G B (A) are picked by name; a single channel is grey whatever its name; of grey and alpha the grey is kept (as
///   pbrt-v4 does); an alpha that is 1 everywhere is dropped.
/// - A file that names its primaries (EXR "chromaticities") is converted to those of sRGB.
/// A file with `pixels` of its own is returned as it is. Throws SceneError at file.where, with OpenImageIO's message.
std::shared_ptr<const ImageData> loadImage(const ImageFile& file);

/// Reads many at once, in parallel; result[i] belongs to files[i]. Throws one Error that lists all that went wrong.
std::vector<std::shared_ptr<const ImageData>> loadImages(std::span<const ImageFile> files);

/// The one channel that a float texture (alpha, roughness, displacement, a mix's amount) reads of an image, as in pbrt-v4:
/// alpha where there is one, else the grey, else the mean of R, G and B. Stays 8-bit where that is exact.
ImageData scalarImage(const ImageData& image);

}  // namespace eikonal
