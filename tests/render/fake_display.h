#pragma once
// A program that shows images, as --display-server expects it: takes a connection, parses every packet, and keeps the images.

#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace eikonal {

class FakeDisplay {
public:
    struct Image {
        int width = 0, height = 0;
        std::map<std::string, std::vector<float>> channels;
        int updates = 0;
    };

    FakeDisplay() {
        socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        if (::bind(socket_, reinterpret_cast<sockaddr*>(&address), size) != 0 || ::listen(socket_, 1) != 0 ||
            ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size) != 0)
            throw std::runtime_error("no socket");
        address_ = "127.0.0.1:" + std::to_string(ntohs(address.sin_port));
        thread_ = std::thread([this] { serve(); });
    }
    ~FakeDisplay() { images(); }

    const std::string& address() const { return address_; }
    /// What has arrived by the end of the connection. Without one it ends at once.
    const std::map<std::string, Image>& images() {
        if (thread_.joinable()) {
            ::shutdown(socket_, SHUT_RD);  // of the listening socket: who has connected is served to the end
            thread_.join();
            ::close(socket_);
        }
        return images_;
    }
    /// What is wrong with what has arrived; empty: nothing. After images().
    const std::string& problem() const { return problem_; }

private:
    /// Reads the numbers and texts of a packet, in order.
    class Reader {
    public:
        explicit Reader(const std::vector<char>& bytes) : bytes_(bytes) {}
        template <class Number>
        Number number() {
            Number value;
            std::memcpy(&value, take(sizeof value), sizeof value);
            return value;
        }
        std::string text() {
            const std::string value = bytes_.data() + at_;  // the vector ends with a zero byte of its own
            take(value.size() + 1);
            return value;
        }
        bool isAtEnd() const { return at_ + 1 == bytes_.size(); }

    private:
        const char* take(std::size_t count) {
            if (at_ + count + 1 > bytes_.size()) throw std::runtime_error("a packet is too short");
            at_ += count;
            return bytes_.data() + at_ - count;
        }
        const std::vector<char>& bytes_;
        std::size_t at_ = 0;
    };

    static void require(bool isTrue, const char* what) {
        if (!isTrue) throw std::runtime_error(what);
    }

    /// Whether there was one.
    bool readBytes(int connection, char* to, std::size_t count) const {
        for (std::size_t got = 0; got < count;) {
            const ssize_t some = ::read(connection, to + got, count - got);
            if (some <= 0) {
                require(got == 0, "the connection ends within a packet");
                return false;
            }
            got += static_cast<std::size_t>(some);
        }
        return true;
    }

    void serve() {
        const int connection = ::accept(socket_, nullptr, nullptr);
        if (connection < 0) return;
        try {
            std::int32_t length = 0;
            while (readBytes(connection, reinterpret_cast<char*>(&length), sizeof length)) {
                require(length > 4 && length < (1 << 20), "a packet has no likely length");
                std::vector<char> bytes(static_cast<std::size_t>(length) - 3);  // without the length, with a zero byte
                require(readBytes(connection, bytes.data(), bytes.size() - 1), "a packet has no content");
                Reader packet(bytes);
                take(packet);
                require(packet.isAtEnd(), "a packet is too long");
            }
        } catch (const std::exception& error) { problem_ = error.what(); }
        ::close(connection);
    }

    void take(Reader& packet) {
        const auto directive = packet.number<std::uint8_t>();
        const auto comesToFront = packet.number<std::uint8_t>();
        require(comesToFront <= 1, "a truth is 0 or 1");
        Image& image = images_[packet.text()];
        if (directive == 4) {
            image = {packet.number<std::int32_t>(), 0, {}};
            image.height = packet.number<std::int32_t>();
            for (int left = packet.number<std::int32_t>(); left > 0; --left)
                image.channels[packet.text()].assign(static_cast<std::size_t>(image.width * image.height), 0.0f);
        } else {
            require(directive == 3, "an unknown directive");
            const auto channel = image.channels.find(packet.text());
            require(channel != image.channels.end(), "an unknown channel");
            const int x0 = packet.number<std::int32_t>(), y0 = packet.number<std::int32_t>(), width = packet.number<std::int32_t>(),
                      height = packet.number<std::int32_t>();
            require(x0 >= 0 && y0 >= 0 && width > 0 && height > 0 && x0 + width <= image.width && y0 + height <= image.height,
                    "a tile is not in the image");
            for (int y = y0; y < y0 + height; ++y)
                for (int x = x0; x < x0 + width; ++x)
                    channel->second[static_cast<std::size_t>(y * image.width + x)] = packet.number<float>();
            ++image.updates;
        }
    }

    int socket_ = -1;
    std::string address_;
    std::thread thread_;
    std::map<std::string, Image> images_;
    std::string problem_;
};

}  // namespace eikonal
