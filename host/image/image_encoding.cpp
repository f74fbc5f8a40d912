#include "image/image_encoding.h"

#include "error.h"
#include "standard_stream.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

namespace eikonal {
namespace {

constexpr std::array<ImageFormat, 11> formats{
    {{"exr", "openexr", ImageContent::layers},
     {"hdr", "hdr", ImageContent::linear, 1 << 30, false},
     {"pfm", "pfm", ImageContent::linear},
     {.extension = "png", .name = "png", .content = ImageContent::screen, .mostBits = 16},
     {"jpg", "jpeg", ImageContent::screen, 65500},
     {"jpeg", "jpeg", ImageContent::screen, 65500},
     {.extension = "tif", .name = "tiff", .content = ImageContent::screen, .bits = 16, .mostBits = 16},
     {.extension = "tiff", .name = "tiff", .content = ImageContent::screen, .bits = 16, .mostBits = 16},
     {"tga", "targa", ImageContent::screen, 65535},
     {"bmp", "bmp", ImageContent::screen},
     {"webp", "webp", ImageContent::screen, 16383}}};

std::string extensionOf(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension;
}

/// The option that asks for what only an EXR has; null: none.
const char* optionOfExr(const ImageEncoding& encoding) {
    return encoding.halfFloats     ? "--pixel-type"
           : encoding.compression  ? "--compression"
           : encoding.channelNames ? "--channel-names"
           : encoding.recordsTime  ? "--record-time"
                                   : nullptr;
}

/// The option that asks for what only integer formats have; null: none.
const char* optionOfIntegers(const ImageEncoding& encoding) {
    const bool needsToneMapping = !encoding.isShown;
    return encoding.bits                           ? "--bit-depth"
           : needsToneMapping && encoding.curve    ? "--tonemap"
           : needsToneMapping && encoding.exposure ? "--exposure"
                                                   : nullptr;
}

/// An option that only images have, and the extension of such an image.
struct OfImages {
    const char* option;     ///< null: none is given
    std::string extension;
};
OfImages optionOfImages(const ImageEncoding& encoding) {
    if (const char* option = optionOfExr(encoding)) return {option, "exr"};
    if (const char* option = optionOfIntegers(encoding)) return {option, "png"};
    return {encoding.format.empty() ? nullptr : "--format", encoding.format};
}

}  // namespace

std::vector<const char*> imageFormatNames() {
    std::vector<const char*> names;
    for (const ImageFormat& format : formats) names.push_back(format.extension);
    return names;
}

const ImageFormat* findImageFormat(const std::string& path, const ImageEncoding& encoding) {
    const std::string extension = encoding.format.empty() ? extensionOf(path) : "." + encoding.format;
    const auto found =
        std::ranges::find_if(formats, [&](const ImageFormat& format) { return extension == std::string(".") + format.extension; });
    return found == formats.end() ? nullptr : &*found;
}

std::string unknownFormat(const std::string& path, const ImageEncoding& encoding) {
    if (findImageFormat(path, encoding)) return {};
    if (isStandardStream(path)) return "it has no extension that would name a format; name one: --format exr";
    const std::string extension = extensionOf(path);
    return fmt::format("{}; known are {}",
                       extension.empty() ? "its name has no extension" : fmt::format("the extension \"{}\" is not known", extension),
                       fmt::join(imageFormatNames(), " "));
}

std::string chosenExtension(const ImageEncoding& encoding) { return encoding.format.empty() ? "exr" : encoding.format; }

bool holdsChannels(const std::string& path, const ImageEncoding& encoding) {
    const ImageFormat* format = findImageFormat(path, encoding);
    return format && format->content == ImageContent::layers;
}

void checkEncoding(const std::vector<std::string>& files, const ImageEncoding& encoding) {
    if (const OfImages of = optionOfImages(encoding); files.empty() && of.option)
        throw UsageError(fmt::format("{} is for images, and only a film is written; add `-o FILE.{}`, or give it to merge", of.option,
                                     of.extension));
    const bool hasExr = std::ranges::any_of(files, [&](const std::string& file) { return holdsChannels(file, encoding); });
    if (const char* option = optionOfExr(encoding); option && !hasExr)
        throw UsageError(fmt::format("{} is for EXR files, and {} {}; add `-o FILE.exr`", option, fmt::join(files, ", "),
                                     files.size() == 1 ? "is none" : "are none"));
    const char* const ofIntegers = optionOfIntegers(encoding);
    if (!ofIntegers) return;
    bool hasIntegers = false;
    for (const std::string& file : files) {
        const ImageFormat* format = findImageFormat(file, encoding);
        if (!format || format->content != ImageContent::screen) continue;
        hasIntegers = true;
        if (encoding.bits.value_or(0) > format->mostBits)
            throw UsageError(fmt::format("--bit-depth {}: {} holds {} bits; png and tif hold 16", *encoding.bits, file, format->mostBits));
    }
    if (!hasIntegers)
        throw UsageError(fmt::format("{} is for integer formats, and {} {}; add `-o FILE.png`{}", ofIntegers, fmt::join(files, ", "),
                                     files.size() == 1 ? "has floats" : "have floats", encoding.bits ? ", or see --pixel-type" : ""));
}

}  // namespace eikonal
