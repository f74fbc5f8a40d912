#pragma once
// Answers requests of browsers. The server is a module of its own, loaded when a page is served, so that other renders start as fast as
// without it.

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace eikonal {

/// A request, with names of headers and parameters as the browser gave them. Empty: it gave none.
struct HttpRequest {
    std::string method, path, host, origin, contentType, body;
    std::map<std::string, std::string> parameters;  ///< of the address, decoded
};

struct HttpAnswer {
    int status = 200;
    std::string type = "text/plain; charset=utf-8", body;
};

/// Called by several threads at a time. May wait.
using HttpHandler = std::function<HttpAnswer(const HttpRequest&)>;

class HttpServer {
public:
    /// Ends once all requests are answered; none is taken any more.
    virtual ~HttpServer() = default;
    virtual int port() const = 0;
};

/// Serves at this address and port; 0: one that is free. Requests of more than 32 KiB, or that take longer than five seconds to arrive, are
/// dropped. Throws an Error if the port is taken, the address is none of this machine, or the module is missing.
std::unique_ptr<HttpServer> serveHttp(const std::string& address, int port, HttpHandler handler);

}  // namespace eikonal

extern "C" {
/// What the module has: null, and why, if it cannot serve.
using eikonal_serve_http_function = eikonal::HttpServer*(const std::string& address, int port, const eikonal::HttpHandler& handler,
                                                         std::string& error);
}
