#pragma once
// Those who watch a render while it goes on.

#include "app/options.h"
#include "app/render_output.h"
#include "diagnostics.h"
#include "render/render.h"
#include "view/display_client.h"

#include <memory>
#include <optional>

namespace eikonal {

/// The program of --display-server. Without it nothing here takes time. All calls are of the thread that renders, between batches, where
/// the film does not change.
class Watching {
public:
    /// Begins to look for the program. The arguments must outlive this object.
    Watching(const Options& options, Diagnostics& diagnostics);

    bool isOn() const { return display_.has_value(); }
    /// Shows the film, if it is time to: that takes at most half a per cent of the render's time.
    void show(const Progress& progress, const Film& film, const RenderOutput& output);
    /// Shows the image that is written.
    void showLast(const FilmImage& image);

private:
    const Options& options_;
    std::optional<DisplayClient> display_;
    double due_ = 0;  ///< seconds of rendering when the next image may be made
};

}  // namespace eikonal
