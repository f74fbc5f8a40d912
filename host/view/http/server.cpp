// The server of host/view/http_server.h, by cpp-httplib.

#include "view/http/limited_stream.h"
#include "view/http_server.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace eikonal {
namespace {

/// Requests that wait for news keep a thread each.
constexpr std::size_t threads = 16;
/// Bytes of a request's body: what the page sends is a word.
constexpr std::size_t longestBody = 1024;

/// What the page does not do is refused by every answer, so that a text that found its way into it could do nothing either.
const httplib::Headers headers{{"Content-Security-Policy",
                                "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src data: blob:; "
                                "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
                               {"Referrer-Policy", "no-referrer"},  // it would tell the token
                               {"X-Content-Type-Options", "nosniff"},
                               {"Cross-Origin-Resource-Policy", "same-origin"},
                               {"Cache-Control", "no-store"}};

/// httplib's server on streams with limits, one request each.
class Transport : public httplib::Server {
    bool process_and_close_socket(socket_t socket) override {
        LimitedStream stream(socket);
        bool isClosed = false;
        const bool isAnswered = process_request(stream, true, isClosed, [](httplib::Request& request) {
            request.ranges.clear();
            request.headers.erase("Accept-Encoding");  // compressing takes more time than the way to this machine's browser
        });
        ::shutdown(socket, SHUT_RDWR);
        ::close(socket);
        return isAnswered;
    }
};

HttpRequest translated(const httplib::Request& request) {
    return {request.method,
            request.path,
            request.get_header_value("Host"),
            request.get_header_value("Origin"),
            request.get_header_value("Content-Type"),
            request.body,
            {request.params.begin(), request.params.end()}};
}

class Server : public HttpServer {
public:
    Server(const std::string& address, int port, const HttpHandler& handler, std::string& error) {
        const auto answer = [handler](const httplib::Request& request, httplib::Response& response) {
            const HttpAnswer answer = handler(translated(request));
            response.status = answer.status;
            response.set_content(answer.body, answer.type);
        };
        transport_.Get(".*", answer);
        transport_.Post(".*", answer);
        transport_.set_exception_handler(
            [](const auto&, httplib::Response& response, const std::exception_ptr&) { response.status = 500; });
        transport_.set_default_headers(headers);
        transport_.set_payload_max_length(longestBody);
        transport_.set_tcp_nodelay(true);
        transport_.new_task_queue = [] { return new httplib::ThreadPool(threads); };
        /* Without SO_REUSEPORT, httplib's default, which would let two renders share a port */
        transport_.set_socket_options([](socket_t socket) {
            const int yes = 1;
            ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
        });
        port_ = port ? (transport_.bind_to_port(address, port) ? port : -1) : transport_.bind_to_any_port(address);
        if (port_ < 0) {
            error = port ? "port " + std::to_string(port) + " of " + address +
                               " is taken, or is none of this machine; another --port may be free"
                         : address + " is no address of this machine";
            return;
        }
        thread_ = std::thread([this] {
            transport_.listen_after_bind();
            hasEnded_ = true;
        });
        while (!transport_.is_running() && !hasEnded_) std::this_thread::yield();  // stop() before that has no effect
    }
    ~Server() override {
        if (!thread_.joinable()) return;
        transport_.stop();
        thread_.join();
    }
    int port() const override { return port_; }

private:
    Transport transport_;
    int port_ = -1;
    std::atomic<bool> hasEnded_ = false;
    std::thread thread_;
};

}  // namespace
}  // namespace eikonal

extern "C" eikonal::HttpServer* eikonal_serve_http(const std::string& address, int port, const eikonal::HttpHandler& handler,
                                                   std::string& error) {
    auto server = std::make_unique<eikonal::Server>(address, port, handler, error);
    return server->port() < 0 ? nullptr : server.release();
}
