#pragma once
// What the page of --view asks for, and may.

#include "image/tone_map.h"
#include "view/http_server.h"
#include "view/live_render.h"

namespace eikonal {

/// Whether a browser may mean this server by the header Host: a name of this machine's own, or the address that is served. Other names are
/// those of pages elsewhere that had their name resolved to this address (DNS rebinding). Any port: it may be forwarded.
bool isOwnHost(const std::string& host, const std::string& servedAddress);

/// Answers below /TOKEN/ alone; anything else does not exist:
///   GET page.html (also by the empty name), page.css, page.js
///   GET state?after=N: JSON, once the state has another number; channels are those of image/channels.h
///   GET values?channels=R,G,B: float32, little-endian, channel after channel, row by row; the image may be newer than the state
///   GET pixel?x=X&y=Y: JSON, the values of all channels of a pixel of the whole image
///   POST wish, JSON {"wish": "pause" | "goOn" | "stop" | "save" | "end"}: 409 if it is not the time for it
class PageRequests {
public:
    PageRequests(LiveRender& render, std::string token, std::string servedAddress, ToneMapping mapping)
        : render_(render), token_(std::move(token)), servedAddress_(std::move(servedAddress)), mapping_(mapping) {}
    HttpAnswer answer(const HttpRequest& request) const;

private:
    HttpAnswer state(const HttpRequest& request) const;
    HttpAnswer values(const HttpRequest& request) const;
    HttpAnswer pixel(const HttpRequest& request) const;
    HttpAnswer wish(const HttpRequest& request) const;

    LiveRender& render_;
    const std::string token_, servedAddress_;
    const ToneMapping mapping_;
};

}  // namespace eikonal
