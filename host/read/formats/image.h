#pragma once
// Decodes image files for textures and environments.

#include "image/image_data.h"
#include "scene/scene.h"

#include <memory>
#include <span>
#include <vector>

namespace eikonal {

/// Reads an image file of the formats in image/formats/signature.h.
///   - 8-bit files stay 8-bit (unless `gamma` is given), all others become floats.
///   - Encoding: sRGB for integers and linear for floats, as in pbrt-v4; `encoding` and `gamma` apply to integers only.
///   - Channels R G B (A) are found by name; a single channel is grey whatever its name; of grey and alpha only grey is kept (as in
///   pbrt-v4); an alpha of 1 everywhere is dropped.
///   - A file with primaries (EXR "chromaticities") is converted to those of sRGB.
/// If the file has `pixels`, returns them. Throws SceneError at file.where, with OpenImageIO's message.
std::shared_ptr<const ImageData> loadImage(const ImageFile& file);

/// The index of a file in scene.images; a new one is added. Files without pixels make the library that decodes them load in the background.
int addImage(Scene& scene, ImageFile file);

/// Reads many files in parallel; result[i] belongs to files[i]. Throws one Error with all problems.
std::vector<std::shared_ptr<const ImageData>> loadImages(std::span<const ImageFile> files);

/// The single channel that a float texture (alpha, roughness, displacement, a mix's amount) reads, as in pbrt-v4: alpha if there is one,
/// else grey, else the mean of R, G and B. Stays 8-bit if that is exact.
ImageData scalarImage(const ImageData& image);

}  // namespace eikonal
