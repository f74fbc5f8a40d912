#pragma once
// How a render is watched while it goes on.

#include <optional>
#include <string>

namespace eikonal {

/// A program that shows images: a host's name or address, and a port.
struct DisplayAddress {
    std::string host, port;
};

struct WatchOptions {
    bool page = false;                      ///< --view: serve a page
    std::string address = "127.0.0.1";      ///< that the page is served at
    int port = 0;                           ///< 0: one that is free
    bool waits = false;                     ///< the page stays after the render, until it is told to end
    std::optional<DisplayAddress> display;  ///< a viewer that speaks tev's protocol
};

}  // namespace eikonal
