#pragma once
// What OpenImageIO does for us. It is a library of its own that is loaded when it is first needed: with all that it needs in turn, it takes as long
// to load as a small scene takes to render.

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

/// Something that an image file says besides its pixels; eight numbers are chromaticities.
using ImageAttribute = std::pair<std::string, std::variant<int, float, std::string, std::array<float, 8>>>;

/// An image that is to become a file.
struct EncodedImage {
    enum class Values { bytes, words, floats } stored = Values::floats;   ///< bytes and words: of [0, 1]
    int width = 0, height = 0;                ///< of what is present
    int x = 0, y = 0;                         ///< where that is in the whole image
    int fullWidth = 0, fullHeight = 0;        ///< of the whole image
    std::vector<std::string> channels;
    std::vector<ImageAttribute> attributes;
    std::vector<float> values;                ///< channel after channel of each pixel, row after row from the top
};

/// An image file that is open.
class ImageReader {
public:
    struct Header {
        int width = 0, height = 0, depth = 1;
        int x = 0, y = 0;                     ///< where the pixels that are present begin in the whole image
        int fullWidth = 0, fullHeight = 0;
        std::vector<std::string> channels;
        bool isFloatingPoint = false;
        bool isBytes = false;                 ///< every channel has 8 bits
        std::size_t bytes = 0;                ///< of all pixels, as they are stored
        std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(depth); }
    };

    virtual ~ImageReader() = default;
    virtual const Header& header() const = 0;
    virtual std::optional<int> integer(const char* name) const = 0;
    virtual std::optional<float> number(const char* name) const = 0;
    virtual std::string text(const char* name) const = 0;                       ///< empty: there is none
    virtual std::optional<std::array<float, 8>> chromaticities() const = 0;
    /// All channels of all pixels, interleaved, into memory for them. False: error() says why.
    virtual bool read(std::uint8_t* values) = 0;
    virtual bool read(float* values) = 0;
    virtual std::string error() = 0;
};

/// Opens and makes files of every format that it knows.
class ImageFormats {
public:
    virtual ~ImageFormats() = default;
    /// Null: `error` says why. isAlphaApart: colours are returned without the alpha that a file has multiplied them by.
    virtual std::unique_ptr<ImageReader> open(const std::string& path, bool isAlphaApart, std::string& error) const = 0;
    /// The content of a file, of a format by its name and its extension. Empty: `error` says why.
    virtual std::vector<unsigned char> encode(const std::string& format, const std::string& extension, const EncodedImage& image, std::string& error) const = 0;
    /// Those of files that can be read: "exr,sgi" of each format after its name, "openexr:exr,sxr;png:png".
    virtual std::string extensions() const = 0;
};

/// Loads the library when first called, from any thread. Throws Error (ExitCode::scene) where that is not possible.
const ImageFormats& imageFormats();

}  // namespace eikonal
