#pragma once
// The page on which a browser shows a render while it goes on.

#include "image/tone_map.h"
#include "view/http_server.h"
#include "view/live_render.h"
#include "view/options.h"
#include "view/page_requests.h"

namespace eikonal {

class PageServer {
public:
    /// mapping: of the image, to begin with. Throws an Error if the page cannot be served.
    PageServer(const WatchOptions& options, const ToneMapping& mapping);
    ~PageServer();

    /// Of the page, with its token.
    std::string url() const;
    LiveRender& render() { return render_; }
    const LiveRender& render() const { return render_; }

private:
    LiveRender render_;
    const std::string address_, token_;
    const PageRequests requests_;
    const std::unique_ptr<HttpServer> server_;
};

}  // namespace eikonal
