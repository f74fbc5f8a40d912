#pragma once
// A connection that a browser has opened, with limits that httplib lacks: on all that one request brings, and on the time that it takes.

#include <httplib.h>

#include <chrono>

namespace eikonal {

class LimitedStream : public httplib::Stream {
public:
    explicit LimitedStream(socket_t socket) : socket_(socket) {}
    bool is_readable() const override;
    bool is_writable() const override;
    /// -1 once the limits are reached.
    ssize_t read(char* to, std::size_t size) override;
    ssize_t write(const char* from, std::size_t size) override;
    void get_remote_ip_and_port(std::string& ip, int& port) const override { ip.clear(), port = 0; }
    void get_local_ip_and_port(std::string& ip, int& port) const override { ip.clear(), port = 0; }
    socket_t socket() const override { return socket_; }

private:
    bool waitFor(short events, std::chrono::steady_clock::time_point end) const;
    const socket_t socket_;
    std::size_t left_ = 32 << 10;  ///< bytes that may still be read
    const std::chrono::steady_clock::time_point readEnd_ = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    char buffer_[4096];  ///< httplib reads byte by byte
    std::size_t at_ = 0, end_ = 0;
};

}  // namespace eikonal
