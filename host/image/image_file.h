#pragma once
// Reads and writes rendered images.

#include "image/film_image.h"
#include "image/image_encoding.h"

#include <cstdint>
#include <string>

namespace eikonal {

/// Writes an image in the format that the encoding names, else that of the file name's extension. The name "-" is standard output
/// (standard_stream.h).
///   - exr: 32-bit floats, linear; with halves, colours and normals are 16-bit floats, clamped to 65504, and in pbrt's spelling all
///   channels. Display window: the image; data window: the pixels present. Channels R G B and, if the image has them, those of
///   image/channels.h and S0.400,000nm (image/spectral_layout.h); Z is 1e10 where there is no surface, as in Blender. Attributes:
///   chromaticities and the metadata.
///   - hdr, pfm: linear, colour only, pixels present only.
///   - png jpg jpeg tga bmp webp (8 bits; png also 16) and tif tiff (16 bits, or 8): pixels present, tone-mapped, encoded as sRGB.
/// Same arguments, same bytes. The file is written completely or not at all (image/atomic_file.h). Throws Error (ExitCode::scene) with the
/// reason.
void writeImage(const std::string& path, const FilmImage& image, const Metadata& metadata, const ImageEncoding& encoding = {});

/// Throws Error if an image has more columns or rows than a file of this name can hold.
void checkHolds(const std::string& path, int columns, int rows, const ImageEncoding& encoding = {});

/// Throws the Error that writeImage would throw, as far as it is foreseeable: unknown extension, no folder, no permission, not a regular
/// file, fewer than `bytes` (an estimate of the file's size) free on the disk; standard output that is a terminal.
void checkWritable(const std::string& path, std::uint64_t bytes = 0, const ImageEncoding& encoding = {});

/// An image read from a file, for tests and comparisons.
struct FilmFile { FilmImage image; Metadata metadata; };

/// Reads a file that writeImage wrote, or any other image. Floats are kept (also those that are not finite), integers decoded from sRGB,
/// grey becomes three equal channels, other primaries are converted to sRGB. Channels may have our names or pbrt-v4's. Throws Error
/// (ExitCode::scene).
FilmFile readImage(const std::string& path);

}  // namespace eikonal
