#pragma once
// Rendered images as files.

#include "image/film_image.h"
#include "image/tone_map.h"

#include <cstdint>
#include <string>

namespace eikonal {

/// Writes an image in the format that the extension names:
/// - exr: 32-bit floats, linear. The image is the display window, what is present the data window. Channels R G B and, where the
///   image has them, albedo.R albedo.G albedo.B, N.X N.Y N.Z, Z, variance, sampleCount, S0.400,000nm (film/spectral_layout.h): layers as Blender and Nuke list them, and
///   what OIDN wants as its guides; Z is 1e10 where there is no surface, as in Blender. Attributes: chromaticities and the metadata.
/// - hdr, pfm: linear, colour only, only what is present.
/// - png jpg jpeg tga bmp webp (8 bits) and tif tiff (16 bits): what is present, tone-mapped, encoded as sRGB.
/// The file appears whole or not at all: it is made beside its place and then renamed. Throws Error (ExitCode::scene) with the reason.
void writeImage(const std::string& path, const FilmImage& image, const Metadata& metadata, const ToneMapping& mapping = {});

/// Whether writeImage keeps channels besides the colour in a file of that name.
bool holdsChannels(const std::string& path);

/// Throws the Error that writeImage would, as far as that can be known before rendering: an unknown extension, no folder, not
/// permitted, no regular file, or less than `bytes` (an estimate of the file's size) free on the disk.
void checkWritable(const std::string& path, std::uint64_t bytes = 0);

/// An image read back, for tests and comparisons.
struct FilmFile { FilmImage image; Metadata metadata; };

/// Reads what writeImage wrote, or any other image file: floats as they are (also those that are not finite), integers decoded from
/// sRGB, grey as three equal channels, other primaries converted to sRGB. Throws Error (ExitCode::scene).
FilmFile readImage(const std::string& path);

}  // namespace eikonal
