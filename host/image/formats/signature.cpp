#include "image/formats/signature.h"

#include "printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include <strings.h>

namespace eikonal {
namespace {

using namespace std::string_view_literals;

constexpr const char* readable = "EXR, PNG, JPEG, HDR, PFM, PNM, TGA, TIFF, BMP and WebP are read";

std::uint32_t littleEndian(const unsigned char* bytes, int count) {
    std::uint32_t value = 0;
    while (count-- > 0) value = value << 8 | bytes[count];
    return value;
}

std::string problemOfBmp(std::string_view text) {
    if (text.size() < 34) return {};  // OpenImageIO says what is missing
    const unsigned char* start = reinterpret_cast<const unsigned char*>(text.data());
    if (littleEndian(start + 14, 4) < 40) return {};  // OS/2's header, which has no compression
    const std::uint32_t bits = littleEndian(start + 28, 2), compression = littleEndian(start + 30, 4);
    constexpr std::uint32_t none = 0, masks = 3;
    if (compression == none || (compression == masks && (bits == 16 || bits == 32))) return {};
    return fmt::format("it is a BMP image with compression {} and {} bits a pixel; such images are read only without compression",
                       compression, bits);
}

/// OpenImageIO multiplies all values by the scale of the header.
std::string problemOfPfm(std::string_view text) {
    std::istringstream header{std::string(text.substr(2))};
    std::string scale;
    for (int words = 0; words < 3 && header >> scale;) {
        const bool isComment = scale.starts_with('#');
        if (isComment) std::getline(header, scale);
        words += isComment ? 0 : 1;
    }
    if (!header.good()) return {};  // the scale is not complete
    const double value = std::strtod(scale.c_str(), nullptr);
    if (std::isfinite(value) && value != 0) return {};
    return fmt::format("its scale is {}; it must be a number other than 0", quoteWord(scale));
}

struct Format {
    std::string_view signature;
    std::size_t offset;
    const char* plugin;  ///< OpenImageIO's name; null: not read
    const char* name;
    std::string (*problem)(std::string_view start) = nullptr;  ///< why OpenImageIO should not see such a file; empty if it may
};

constexpr Format formats[] = {
    {"\x76\x2f\x31\x01"sv, 0, "openexr", "an EXR image"},
    {"\x89PNG\r\n\x1a\n"sv, 0, "png", "a PNG image"},
    {"\xff\xd8\xff"sv, 0, "jpeg", "a JPEG image"},
    {"#?"sv, 0, "hdr", "an HDR image"},
    {"PF"sv, 0, "pnm", "a PFM image", problemOfPfm},
    {"Pf"sv, 0, "pnm", "a PFM image", problemOfPfm},
    {"P1"sv, 0, "pnm", "a PNM image"},
    {"P2"sv, 0, "pnm", "a PNM image"},
    {"P3"sv, 0, "pnm", "a PNM image"},
    {"P4"sv, 0, "pnm", "a PNM image"},
    {"P5"sv, 0, "pnm", "a PNM image"},
    {"P6"sv, 0, "pnm", "a PNM image"},
    {"II*\0"sv, 0, "tiff", "a TIFF image"},
    {"MM\0*"sv, 0, "tiff", "a TIFF image"},
    {"II+\0"sv, 0, "tiff", "a TIFF image"},
    {"MM\0+"sv, 0, "tiff", "a TIFF image"},
    {"BM"sv, 0, "bmp", "a BMP image", problemOfBmp},
    {"WEBP"sv, 8, "webp", "a WebP image"},
    {"GIF8"sv, 0, nullptr, "a GIF image"},
    {"8BPS"sv, 0, nullptr, "a Photoshop image"},
    {"DDS "sv, 0, nullptr, "a DDS image"},
    {"jP  "sv, 4, nullptr, "a JPEG 2000 image"},
    {"\xff\x4f\xff\x51"sv, 0, nullptr, "a JPEG 2000 image"},
    {"JXL "sv, 4, nullptr, "a JPEG XL image"},
    {"\xff\x0a"sv, 0, nullptr, "a JPEG XL image"},
    {"ftypavif"sv, 4, nullptr, "an AVIF image"},
    {"ftyp"sv, 4, nullptr, "a HEIF image or a film"},
    {"\xabKTX"sv, 0, nullptr, "a KTX image"},
    {"SDPX"sv, 0, nullptr, "a DPX image"},
    {"XPDS"sv, 0, nullptr, "a DPX image"},
    {"\x01\xda"sv, 0, nullptr, "an SGI image"},
    {"SIMPLE  ="sv, 0, nullptr, "a FITS image"},
    {"<svg"sv, 0, nullptr, "an SVG image"},
    {"<?xml"sv, 0, nullptr, "an XML file"},
    {"version https://git-lfs"sv, 0, nullptr, "a placeholder of Git LFS; fetch the file itself with \"git lfs pull\""},
};

/// Whether a TGA file that is compressed by run lengths has all of its pixels.
bool hasAllRuns(std::ifstream& file, std::size_t pixels, std::size_t bytesOfPixel) {
    std::vector<char> skipped(128 * bytesOfPixel);
    while (pixels > 0) {
        const int packet = file.get();
        if (packet < 0) return false;
        const std::size_t count = (static_cast<unsigned>(packet) & 127) + 1;
        const std::size_t bytes = packet & 128 ? bytesOfPixel : count * bytesOfPixel;
        if (!file.read(skipped.data(), static_cast<std::streamsize>(bytes))) return false;
        pixels -= std::min(pixels, count);
    }
    return true;
}

/// What is wrong with a TGA file; nothing if its header is not one of TGA.
std::optional<std::string> problemOfTga(std::ifstream& file, std::size_t fileSize, const unsigned char* start) {
    const int hasColorMap = start[1], kind = start[2], bits = start[16];
    const std::size_t width = littleEndian(start + 12, 2), height = littleEndian(start + 14, 2);
    const bool isRunLength = kind & 8;
    const bool isSize = bits == 8 || bits == 15 || bits == 16 || bits == 24 || bits == 32;
    if (hasColorMap > 1 || (kind & ~8) < 1 || (kind & ~8) > 3 || width == 0 || height == 0 || !isSize) return {};
    const std::size_t bytesOfPixel = static_cast<std::size_t>((bits + 7) / 8);
    const std::size_t colorMap = hasColorMap ? littleEndian(start + 5, 2) * ((start[7] + 7u) / 8) : 0, before = 18 + start[0] + colorMap;
    file.clear();
    file.seekg(static_cast<std::streamoff>(before));
    const bool isWhole = isRunLength ? hasAllRuns(file, width * height, bytesOfPixel) : before + width * height * bytesOfPixel <= fileSize;
    return isWhole ? "" : fmt::format("it ends before its {} x {} pixels are complete", width, height);
}

bool isCalledTga(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    return std::ranges::any_of(std::array{".tga", ".tpic", ".icb", ".vda", ".vst"},
                               [&](const char* known) { return ::strcasecmp(extension.c_str(), known) == 0; });
}

}  // namespace

ImageSignature recognizeImage(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) return {nullptr, "there is no such file"};
    if (std::filesystem::is_directory(path, error)) return {nullptr, "it is a folder"};
    if (!std::filesystem::is_regular_file(path, error)) return {nullptr, "it is not a file, but a device or a pipe"};
    std::ifstream file(path, std::ios::binary);
    if (!file) return {nullptr, std::strerror(errno)};
    std::array<unsigned char, 1024> start{};  // headers may have comments
    file.read(reinterpret_cast<char*>(start.data()), start.size());
    const std::string_view text(reinterpret_cast<const char*>(start.data()), static_cast<std::size_t>(file.gcount()));
    if (text.empty()) return {nullptr, "it is empty"};

    for (const Format& format : formats) {
        if (text.size() < format.offset || !text.substr(format.offset).starts_with(format.signature)) continue;
        if (!format.plugin) return {nullptr, fmt::format("it is {}; {}", format.name, readable)};
        if (const std::string problem = format.problem ? format.problem(text) : ""; !problem.empty()) return {nullptr, problem};
        return {format.plugin, {}};
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (const auto problem = isCalledTga(path) ? problemOfTga(file, size, start.data()) : std::nullopt)
        return {problem->empty() ? "targa" : nullptr, *problem};
    return {nullptr, fmt::format("its format is not known; {}", readable)};
}

}  // namespace eikonal
