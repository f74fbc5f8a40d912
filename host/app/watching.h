#pragma once
// Those who watch a render while it goes on.

#include "app/checkpoint.h"
#include "app/options.h"
#include "app/render_output.h"
#include "diagnostics.h"
#include "render/render.h"
#include "view/display_client.h"
#include "view/page_server.h"

#include <optional>

namespace eikonal {

/// The page of --view and the program of --display-server. Without them nothing here takes time. The thread that renders calls this between
/// batches, where the film does not change.
class Watching {
public:
    /// Serves the page, whose address it prints, and looks for the program. The arguments must outlive this object. Throws an Error if the
    /// page cannot be served.
    Watching(const Options& options, Diagnostics& diagnostics);

    bool isOn() const { return display_ || page_; }
    /// Rendering begins: pixels get up to so many samples.
    void begin(const Session& session, unsigned samples);
    /// Shows the film, if it is time to: that takes at most half a per cent of the render's time.
    void show(const Progress& progress, Session& session, const Film& film, const RenderOutput& output);
    /// Writes the files if the page asks for that, and waits while it pauses the render, but no longer than until `isOver`. seconds: of
    /// rendering.
    void obey(Session& session, const Film& film, std::span<const unsigned> planned, double seconds, Checkpoints& checkpoints,
              RenderOutput& output, const std::function<bool()>& isOver);
    /// Passes on that the page has stopped the render, as if by Ctrl-C. Any thread may call this.
    void passOnStop() const;
    /// Seconds for which the render has been paused; progress without them.
    double pausedSeconds() const { return pausedSeconds_; }
    Progress withoutPauses(Progress progress) const;

    /// Shows the image that is written.
    void showLast(const FilmImage& image, const ErrorEstimate& error, double seconds);
    /// The files are written. Waits for the page's last look, or until it ends the program if that is asked for.
    void end(const std::string& how, const std::vector<std::string>& files);

private:
    void showFilm(Session& session, const Film& film, double seconds, const RenderOutput& output);

    const Options& options_;
    std::optional<DisplayClient> display_;
    std::optional<PageServer> page_;
    double due_ = 0;  ///< seconds of rendering when the next image may be made
    double pausedSeconds_ = 0;
};

}  // namespace eikonal
