#pragma once
// Interface to OpenImageIO. It is a separate library, loaded on first use, because loading OpenImageIO with its dependencies takes as long
// as rendering a small scene.

#include "image/image_encoding.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace eikonal {

/// An attribute of an image file; eight numbers are chromaticities, sixteen a matrix as the file stores it.
using ImageAttribute = std::pair<std::string, std::variant<int, float, std::string, std::array<float, 8>, std::array<float, 16>>>;

/// An image to be encoded.
struct EncodedImage {
    enum class Values { bytes, words, floats } stored = Values::floats;   ///< bytes and words: values in [0, 1]
    int width = 0, height = 0;                ///< size of the pixels present
    int x = 0, y = 0;                         ///< their position in the whole image
    int fullWidth = 0, fullHeight = 0;        ///< size of the whole image
    std::vector<std::string> channels;
    std::vector<bool> isHalf;                 ///< OpenEXR: which channels have 16 bits; empty: none
    ExrCompression compression = ExrCompression::zip;
    std::vector<ImageAttribute> attributes;
    std::vector<float> values;                ///< channels interleaved, row by row from the top
};

/// An image file that is open.
class ImageReader {
public:
    struct Header {
        int width = 0, height = 0, depth = 1;
        int x = 0, y = 0;                     ///< position of the pixels present in the whole image
        int fullWidth = 0, fullHeight = 0;
        std::vector<std::string> channels;
        bool isFloatingPoint = false;
        bool isBytes = false;                 ///< every channel has 8 bits
        std::size_t bytes = 0;                ///< size of all pixels as stored
        std::size_t pixels() const {
            return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(depth);
        }
    };

    virtual ~ImageReader() = default;
    virtual const Header& header() const = 0;
    virtual std::optional<int> integer(const char* name) const = 0;
    virtual std::optional<float> number(const char* name) const = 0;
    virtual std::string text(const char* name) const = 0;                       ///< empty: no such attribute
    virtual std::optional<std::array<float, 8>> chromaticities() const = 0;
    virtual std::optional<std::array<float, 16>> matrix(const char* name) const = 0;   ///< by OpenImageIO's name, as the file stores it
    /// Reads all channels of all pixels, interleaved. On failure returns false, and error() has the reason.
    virtual bool read(std::uint8_t* values) = 0;
    virtual bool read(float* values) = 0;
    virtual std::string error() = 0;
};

/// Reads and writes files by OpenImageIO.
class ImageFormats {
public:
    virtual ~ImageFormats() = default;
    /// Opens a file of a format, which OpenImageIO calls so; null on failure, with the reason in `error`. isAlphaApart: undo the
    /// multiplication of colours by alpha.
    virtual std::unique_ptr<ImageReader> open(const std::string& path, const std::string& format, bool isAlphaApart,
                                              std::string& error) const = 0;
    /// The content of a file in a format given by name and extension. Empty on failure, with the reason in `error`.
    virtual std::vector<unsigned char> encode(const std::string& format, const std::string& extension, const EncodedImage& image,
                                              std::string& error) const = 0;
};

/// Loads the library on the first call; thread-safe. Throws Error (ExitCode::scene) if it cannot be loaded.
const ImageFormats& imageFormats();

/// Begins to load the library beside the calling thread, so that imageFormats() need not wait as long; does nothing after the first call.
void beginLoadingImageFormats();

/// Opens an image file of a format that is read (image/formats/signature.h). Null on failure, with the reason in `error`.
std::unique_ptr<ImageReader> openImage(const std::string& path, bool isAlphaApart, std::string& error);

}  // namespace eikonal
