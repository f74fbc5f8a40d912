#include "image/encode_exr.h"

#include "image/half_floats.h"

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <half.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <mutex>
#include <system_error>

namespace eikonal {
namespace {

class MemoryStream : public Imf::OStream {
public:
    explicit MemoryStream(std::vector<unsigned char>& bytes) : OStream("image.exr"), bytes_(bytes) {}

    void write(const char* data, int count) override {
        const std::size_t end = at_ + static_cast<std::size_t>(count);
        if (bytes_.size() < end) bytes_.resize(end);
        std::copy_n(data, count, bytes_.begin() + static_cast<std::ptrdiff_t>(at_));
        at_ = end;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t at) override { at_ = at; }

private:
    std::vector<unsigned char>& bytes_;
    std::size_t at_ = 0;
};

struct AttributeWriter {
    Imf::Header& header;
    const std::string& name;
    void operator()(int value) const { header.insert(name, Imf::IntAttribute(value)); }
    void operator()(float value) const { header.insert(name, Imf::FloatAttribute(value)); }
    void operator()(const std::string& value) const { header.insert(name, Imf::StringAttribute(value)); }
    void operator()(const std::array<float, 8>& c) const {
        header.insert(name, Imf::ChromaticitiesAttribute(Imf::Chromaticities({c[0], c[1]}, {c[2], c[3]}, {c[4], c[5]}, {c[6], c[7]})));
    }
    void operator()(const std::array<float, 16>& m) const {
        Imath::M44f stored;
        std::ranges::copy(m, stored.getValue());
        header.insert(name, Imf::M44fAttribute(stored));
    }
};

/// Threads that compress lines of a file, as many as the program may use, while this object lives; one file at a time. They change no
/// byte: OpenEXR writes blocks of lines in their order. None: the calling thread compresses, if the system has no more threads.
class CompressionThreads {
public:
    CompressionThreads() {
        const auto allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
        try {
            Imf::setGlobalThreadCount(allowed > 1 ? static_cast<int>(allowed) : 0);
        } catch (const std::system_error&) { Imf::setGlobalThreadCount(0); }
    }
    ~CompressionThreads() { Imf::setGlobalThreadCount(0); }
    CompressionThreads(const CompressionThreads&) = delete;
    CompressionThreads& operator=(const CompressionThreads&) = delete;
    int count() const { return Imf::globalThreadCount(); }

private:
    static inline std::mutex one_;
    const std::scoped_lock<std::mutex> lock_{one_};
};

/// The values of the channels that have 16 bits, interleaved.
std::vector<Imath::half> halvesOf(const EncodedImage& image) {
    std::vector<Imath::half> halves;
    if (std::ranges::none_of(image.isHalf, [](bool isHalf) { return isHalf; })) return halves;
    for (std::size_t i = 0; i < image.values.size(); ++i)
        if (image.isHalf[i % image.channels.size()]) halves.emplace_back(std::clamp(image.values[i], -mostHalf, mostHalf));
    return halves;
}

}  // namespace

std::vector<unsigned char> encodeExr(const EncodedImage& image) {
    const Imath::Box2i display({0, 0}, {image.fullWidth - 1, image.fullHeight - 1});
    const Imath::Box2i data({image.x, image.y}, {image.x + image.width - 1, image.y + image.height - 1});
    Imf::Header header(display, data, 1, {0, 0}, 1, Imf::INCREASING_Y, static_cast<Imf::Compression>(image.compression));
    for (const auto& [name, value] : image.attributes) std::visit(AttributeWriter{header, name}, value);

    /* OpenEXR wants the address that pixel (0, 0) would have */
    const std::size_t channels = image.channels.size(), width = static_cast<std::size_t>(image.width);
    const std::vector<Imath::half> halves = halvesOf(image);
    const std::size_t halfChannels = static_cast<std::size_t>(std::ranges::count(image.isHalf, true));
    Imf::FrameBuffer buffer;
    std::size_t half = 0;
    for (std::size_t c = 0; c < channels; ++c) {
        const auto insert = [&](Imf::PixelType type, const auto* first, std::size_t perPixel) {
            const std::size_t pixel = perPixel * sizeof *first;
            header.channels().insert(image.channels[c], Imf::Channel(type));
            buffer.insert(image.channels[c], Imf::Slice::Make(type, first, data, pixel, width * pixel));
        };
        if (halfChannels && image.isHalf[c]) insert(Imf::HALF, halves.data() + half++, halfChannels);
        else insert(Imf::FLOAT, image.values.data() + c, channels);
    }
    std::vector<unsigned char> bytes;
    {
        MemoryStream stream(bytes);
        const CompressionThreads threads;
        Imf::OutputFile file(stream, header, threads.count());
        file.setFrameBuffer(buffer);
        file.writePixels(image.height);
    }
    return bytes;
}

}  // namespace eikonal
