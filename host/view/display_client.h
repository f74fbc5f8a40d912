#pragma once
// Shows a render in another program, such as tev, while it goes on.

#include "image/film_image.h"
#include "view/options.h"

#include <functional>
#include <memory>
#include <string>
#include <thread>

namespace eikonal {

/// Sends images from a thread of its own, so that a program that is slow, absent or gone costs the render nothing. It is tried again with
/// each image; the first failure is told.
class DisplayClient {
public:
    /// title: the image's name there. warn: told why the program cannot be reached, at most once, by another thread.
    DisplayClient(DisplayAddress address, std::string title, std::function<void(const std::string&)> warn);
    /// Sends the last image, for some seconds at most.
    ~DisplayClient();
    DisplayClient(const DisplayClient&) = delete;
    DisplayClient& operator=(const DisplayClient&) = delete;

    /// What is to be seen from now on. An image that could not be sent by then is left out.
    void show(std::shared_ptr<const FilmImage> image);

private:
    struct State;
    std::shared_ptr<State> state_;  ///< outlives this where finding the address takes long
    std::thread thread_;
};

}  // namespace eikonal
