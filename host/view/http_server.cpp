#include "view/http_server.h"

#include "error.h"

#include <fmt/format.h>

#include <dlfcn.h>

namespace eikonal {

std::unique_ptr<HttpServer> serveHttp(const std::string& address, int port, HttpHandler handler) {
    /* The dynamic linker finds it in the program's run path */
    void* const library = ::dlopen("libeikonal_http.so", RTLD_LAZY | RTLD_LOCAL);
    void* const symbol = library ? ::dlsym(library, "eikonal_serve_http") : nullptr;
    if (!symbol) throw Error(ExitCode::scene, fmt::format("--view: no page can be served: {}", ::dlerror()));
    std::string problem;
    std::unique_ptr<HttpServer> server(reinterpret_cast<eikonal_serve_http_function*>(symbol)(address, port, handler, problem));
    if (!server) throw Error(ExitCode::usage, fmt::format("--view: {}", problem));
    return server;
}

}  // namespace eikonal
