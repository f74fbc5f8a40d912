// The library libeikonal_openimageio.so.

#include "image/formats/image_formats.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <string>
#include <string_view>

namespace eikonal {
namespace {

using OIIO::TypeDesc;

const TypeDesc eightNumbers(TypeDesc::FLOAT, 8);

class Reader : public ImageReader {
public:
    explicit Reader(std::unique_ptr<OIIO::ImageInput> input) : input_(std::move(input)) {
        const OIIO::ImageSpec& s = spec();
        header_ = {s.width,
                   s.height,
                   s.depth,
                   s.x - s.full_x,
                   s.y - s.full_y,
                   s.full_width,
                   s.full_height,
                   s.channelnames,
                   s.format.is_floating_point(),
                   s.format == TypeDesc::UINT8 && s.channelformats.empty(),
                   static_cast<std::size_t>(s.image_bytes())};
    }

    const Header& header() const override { return header_; }
    std::optional<int> integer(const char* name) const override { return get<int>(name, TypeDesc::INT); }
    std::optional<float> number(const char* name) const override { return get<float>(name, TypeDesc::FLOAT); }
    std::string text(const char* name) const override { return std::string(spec().get_string_attribute(name)); }
    std::optional<std::array<float, 8>> chromaticities() const override {
        return get<std::array<float, 8>>("chromaticities", eightNumbers);
    }
    std::optional<std::array<float, 16>> matrix(const char* name) const override {
        return get<std::array<float, 16>>(name, OIIO::TypeMatrix);
    }
    bool read(std::uint8_t* values) override { return read(TypeDesc::UINT8, values); }
    bool read(float* values) override { return read(TypeDesc::FLOAT, values); }
    std::string error() override { return error_; }

private:
    bool read(TypeDesc type, void* values) {
        const bool succeeds = input_->read_image(0, 0, 0, spec().nchannels, type, values);
        error_ = input_->geterror();
        if (!succeeds && error_.empty()) error_ = "it is damaged, or ends before its pixels are complete";
        /* OpenImageIO reports success for these when pixels are missing */
        const bool isTiff = input_->format_name() == std::string_view("tiff");
        const bool isCut = isTiff ? !error_.empty() : error_.find("Premature end") != error_.npos;
        return succeeds && !isCut;
    }

    const OIIO::ImageSpec& spec() const { return input_->spec(); }
    template <class T> std::optional<T> get(const char* name, TypeDesc type) const {
        T value{};
        return spec().getattribute(name, type, &value) ? std::optional(value) : std::nullopt;
    }

    std::unique_ptr<OIIO::ImageInput> input_;
    Header header_;
    std::string error_;
};

/// Why pixels of a TIFF file are not read; empty if they are. OpenImageIO 2.4 writes beyond its memory for some other kinds (its issue
/// 5315).
std::string problemOfTiff(const OIIO::ImageSpec& spec) {
    const int photometric = spec.get_int_attribute("tiff:PhotometricInterpretation", -1);
    const int bits = spec.get_int_attribute("oiio:BitsPerSample");
    const bool isColor = photometric >= 0 && photometric <= 3, isYcbcr = photometric == 6;  // grey, RGB, a colour map
    if ((isColor || isYcbcr) && (bits == 8 || bits == 16 || bits == 32)) return {};
    return "it is a TIFF image with " + std::to_string(bits) + " bits a channel and photometric interpretation " +
           std::to_string(photometric) + "; grey and RGB with 8, 16 or 32 bits are read";
}

struct AttributeWriter {
    OIIO::ImageSpec& spec;
    const std::string& name;
    void operator()(int value) const { spec.attribute(name, value); }
    void operator()(float value) const { spec.attribute(name, value); }
    void operator()(const std::string& value) const { spec.attribute(name, value); }
    void operator()(const std::array<float, 8>& value) const { spec.attribute(name, eightNumbers, value.data()); }
    void operator()(const std::array<float, 16>& value) const { spec.attribute(name, OIIO::TypeMatrix, value.data()); }
};

OIIO::ImageSpec specOf(const std::string& format, const EncodedImage& image) {
    using enum EncodedImage::Values;
    const TypeDesc type = image.stored == bytes ? TypeDesc::UINT8 : image.stored == words ? TypeDesc::UINT16 : TypeDesc::FLOAT;
    OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()), type);
    spec.channelnames = image.channels;
    // Not for TIFF: OpenImageIO 2.4 would add an EXIF directory, which damages a file in memory.
    if (image.stored != floats && format != "tiff") spec.attribute("oiio:ColorSpace", "sRGB");
    if (format == "jpeg" || format == "webp") spec.attribute("compression", format + ":95");
    if (format == "jpeg") spec.attribute("jpeg:subsampling", "4:4:4");
    // Else OpenImageIO adds the present time; this is how an unknown one is spelled (EXIF 2.3, 4.6.4).
    if (format == "tiff") spec.attribute("DateTime", "    :  :     :  :  ");
    for (const auto& [name, value] : image.attributes) std::visit(AttributeWriter{spec, name}, value);
    return spec;
}

class Formats : public ImageFormats {
public:
    std::unique_ptr<ImageReader> open(const std::string& path, const std::string& format, bool isAlphaApart,
                                      std::string& error) const override {
        OIIO::ImageSpec request, spec;
        if (isAlphaApart) request.attribute("oiio:UnassociatedAlpha", 1);
        auto input = OIIO::ImageInput::create(format);
        if (!input) error = OIIO::geterror();
        else if (!input->open(path, spec, request)) error = input->geterror();
        else error = format == "tiff" ? problemOfTiff(spec) : "";
        return error.empty() && input ? std::make_unique<Reader>(std::move(input)) : nullptr;
    }

    std::vector<unsigned char> encode(const std::string& format, const std::string& extension, const EncodedImage& image,
                                      std::string& error) const override {
        std::vector<unsigned char> bytes;
        OIIO::Filesystem::IOVecOutput memory(bytes);
        auto output = OIIO::ImageOutput::create(format);
        if (!output) {
            error = OIIO::geterror();
            return {};
        }
        if (output->set_ioproxy(&memory) && output->open("image." + extension, specOf(format, image)) &&
            output->write_image(TypeDesc::FLOAT, image.values.data()) && output->close())
            return bytes;
        error = output->geterror();
        return {};
    }
};

}  // namespace
}  // namespace eikonal

extern "C" const eikonal::ImageFormats* eikonal_image_formats() {
    static const eikonal::Formats formats;
    return &formats;
}
