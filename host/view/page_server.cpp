#include "view/page_server.h"

#include "view/token.h"

#include <fmt/format.h>

namespace eikonal {

PageServer::PageServer(const WatchOptions& options, const ToneMapping& mapping)
    : address_(options.address),
      token_(randomToken()),
      requests_(render_, token_, address_, mapping),
      server_(serveHttp(address_, options.port, [this](const HttpRequest& request) { return requests_.answer(request); })) {}

PageServer::~PageServer() { render_.close(); }

std::string PageServer::url() const {
    return fmt::format("http://{}:{}/{}/", address_.find(':') == std::string::npos ? address_ : "[" + address_ + "]", server_->port(),
                       token_);
}

}  // namespace eikonal
