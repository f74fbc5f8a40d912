#include "view/display_packets.h"

#include <bit>
#include <cstdint>
#include <cstring>

namespace eikonal {
namespace {

static_assert(std::endian::native == std::endian::little, "packets hold numbers as they are in memory");

enum class Directive : unsigned char { updateImage = 3, createImage = 4 };

class Packet {
public:
    Packet(Directive directive, bool comesToFront) {
        add(std::int32_t(0));  // the length, once it is known
        add(directive);
        add(static_cast<unsigned char>(comesToFront));
    }
    void add(const std::string& text) { addBytes(text.c_str(), text.size() + 1); }
    template <class Number>
    void add(Number number) {
        addBytes(&number, sizeof number);
    }
    void add(std::span<const float> values) { addBytes(values.data(), values.size_bytes()); }
    DisplayPacket finish() {
        const auto length = static_cast<std::int32_t>(bytes_.size());
        std::memcpy(bytes_.data(), &length, sizeof length);
        return std::move(bytes_);
    }

private:
    void addBytes(const void* first, std::size_t count) {
        const auto* begin = static_cast<const unsigned char*>(first);
        bytes_.insert(bytes_.end(), begin, begin + count);
    }
    DisplayPacket bytes_;
};

}  // namespace

DisplayPacket createImagePacket(const std::string& name, int width, int height, std::span<const std::string> channels) {
    Packet packet(Directive::createImage, true);
    packet.add(name);
    packet.add(static_cast<std::int32_t>(width));
    packet.add(static_cast<std::int32_t>(height));
    packet.add(static_cast<std::int32_t>(channels.size()));
    for (const std::string& channel : channels) packet.add(channel);
    return packet.finish();
}

DisplayPacket updateImagePacket(const std::string& name, const std::string& channel, const PixelBounds& tile,
                                std::span<const float> values) {
    Packet packet(Directive::updateImage, false);
    packet.add(name);
    packet.add(channel);
    for (const int number : {tile.x0, tile.y0, tile.x1 - tile.x0, tile.y1 - tile.y0}) packet.add(static_cast<std::int32_t>(number));
    packet.add(values);
    return packet.finish();
}

}  // namespace eikonal
