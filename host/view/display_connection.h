#pragma once
// A connection to a program that shows images.

#include "view/options.h"

#include <span>

namespace eikonal {

class DisplayConnection {
public:
    DisplayConnection() = default;
    ~DisplayConnection() { close(); }
    DisplayConnection(const DisplayConnection&) = delete;
    DisplayConnection& operator=(const DisplayConnection&) = delete;

    bool isOpen() const { return socket_ >= 0; }
    /// Connects anew. Throws a std::runtime_error with the reason. Takes some seconds at most, beside finding the host's address.
    void open(const DisplayAddress& address);
    /// Throws a std::runtime_error, and closes, if the other side has gone or takes nothing for some seconds.
    void send(std::span<const unsigned char> bytes);
    void close();

private:
    int socket_ = -1;
};

}  // namespace eikonal
