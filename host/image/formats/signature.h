#pragma once
// Which image files are read: those whose first bytes belong to a format of a short list. OpenImageIO reads many more formats, some of them
// with errors that a file can use to write beyond its memory, and chooses among them by content, whatever a file is called.

#include <string>

namespace eikonal {

/// What a file was recognized as.
struct ImageSignature {
    const char* format = nullptr;  ///< OpenImageIO's name of the format; null: the file is not read
    std::string problem;           ///< why not, to follow "cannot read image NAME: "
};

/// Reads the first bytes of a file: EXR, PNG, JPEG, HDR, PFM, PNM, TGA, TIFF, uncompressed BMP and WebP are recognized. TGA has none:
/// such a file needs the extension and a plausible header, and all of its pixels. Never throws.
ImageSignature recognizeImage(const std::string& path);

}  // namespace eikonal
