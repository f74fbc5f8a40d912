#include "image/encode_png.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <stdexcept>

namespace eikonal {
namespace {

/// Target of libpng's output and errors. Errors leave by longjmp, which skips no destructor here.
struct Encoding {
    std::vector<unsigned char> bytes;
    std::string error;
};

void append(png_structp png, png_bytep data, png_size_t count) {
    auto& bytes = static_cast<Encoding*>(png_get_io_ptr(png))->bytes;
    bytes.insert(bytes.end(), data, data + count);
}

void fail(png_structp png, png_const_charp message) {
    static_cast<Encoding*>(png_get_error_ptr(png))->error = message;
    png_longjmp(png, 1);
}

void ignore(png_structp, png_const_charp) {}

std::vector<png_byte> bytesOf(const std::vector<float>& values) {
    std::vector<png_byte> bytes(values.size());
    std::ranges::transform(values, bytes.begin(),
                           [](float value) { return static_cast<png_byte>(std::clamp(value, 0.f, 1.f) * 255 + 0.5f); });
    return bytes;
}

/// Of two bytes each, the higher one first.
std::vector<png_byte> wordsOf(const std::vector<float>& values) {
    std::vector<png_byte> bytes;
    bytes.reserve(2 * values.size());
    for (const float value : values) {
        const auto word = static_cast<png_uint_16>(std::clamp(value, 0.f, 1.f) * 65535 + 0.5f);
        bytes.push_back(static_cast<png_byte>(word >> 8));
        bytes.push_back(static_cast<png_byte>(word & 255));
    }
    return bytes;
}

bool writePng(png_structp png, png_infop info, const EncodedImage& image, std::vector<png_text>& texts, std::vector<png_bytep>& rows) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
                 image.stored == EncodedImage::Values::words ? 16 : 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_ABSOLUTE);
    png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
    png_write_info(png, info);
    png_write_image(png, rows.data());
    png_write_end(png, info);
    return true;
}

}  // namespace

std::vector<unsigned char> encodePng(const EncodedImage& image) {
    const std::size_t perValue = image.stored == EncodedImage::Values::words ? 2 : 1,
                      row = perValue * 3 * static_cast<std::size_t>(image.width);
    std::vector<png_byte> pixels = perValue == 2 ? wordsOf(image.values) : bytesOf(image.values);
    std::vector<png_bytep> rows;
    for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) rows.push_back(&pixels[y * row]);
    std::vector<png_text> texts;
    for (const auto& [name, value] : image.attributes)
        if (const auto* text = std::get_if<std::string>(&value)) {
            png_text entry{};
            entry.compression = PNG_TEXT_COMPRESSION_NONE;
            entry.key = const_cast<png_charp>(name.c_str());
            entry.text = const_cast<png_charp>(text->c_str());
            texts.push_back(entry);
        }

    Encoding encoding;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &encoding, fail, ignore);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    if (info) png_set_write_fn(png, &encoding, append, nullptr);
    const bool isWritten = info && writePng(png, info, image, texts, rows);
    png_destroy_write_struct(&png, &info);
    if (!isWritten) throw std::runtime_error(encoding.error.empty() ? "not enough memory" : encoding.error);
    return std::move(encoding.bytes);
}

}  // namespace eikonal
