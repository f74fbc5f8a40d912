#include "view/display_connection.h"

#include <cerrno>
#include <cstring>
#include <memory>
#include <stdexcept>

#include <netdb.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

namespace eikonal {

/// How long connecting may take, and how long the other side may take nothing. Linux applies it to connect(), too.
constexpr timeval patience{3, 0};

void DisplayConnection::open(const DisplayAddress& address) {
    close();
    addrinfo hints{}, *first = nullptr;
    hints.ai_socktype = SOCK_STREAM;
    if (const int error = ::getaddrinfo(address.host.c_str(), address.port.c_str(), &hints, &first))
        throw std::runtime_error(::gai_strerror(error));
    const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> owner(first, ::freeaddrinfo);
    int error = ECONNREFUSED;
    for (const addrinfo* each = first; each && socket_ < 0; each = each->ai_next) {
        socket_ = ::socket(each->ai_family, each->ai_socktype | SOCK_CLOEXEC, each->ai_protocol);
        if (socket_ >= 0 && ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience) == 0 &&
            ::connect(socket_, each->ai_addr, each->ai_addrlen) == 0)
            return;
        error = errno == EINPROGRESS ? ETIMEDOUT : errno;
        close();
    }
    throw std::runtime_error(std::strerror(error));
}

void DisplayConnection::send(std::span<const unsigned char> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) {
            const int error = errno == EAGAIN ? ETIMEDOUT : errno;
            close();
            throw std::runtime_error(std::strerror(error));
        }
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
}

void DisplayConnection::close() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
}

}  // namespace eikonal
