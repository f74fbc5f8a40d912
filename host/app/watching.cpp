#include "app/watching.h"

#include "clock.h"

#include <fmt/format.h>

#include <algorithm>

#include <unistd.h>

namespace eikonal {

/// Making images for those who watch takes at most this share of the render's time, and they come no closer than this, in seconds.
constexpr double shareForImages = 0.005, secondsBetweenImages = 0.25;

Watching::Watching(const Options& options, Diagnostics& diagnostics) : options_(options) {
    if (options.watch.display)
        display_.emplace(*options.watch.display, fmt::format("{} ({})", options.scene.path, ::getpid()),
                         [&diagnostics](const std::string& problem) { diagnostics.warn({}, problem); });
}

void Watching::show(const Progress& progress, const Film& film, const RenderOutput& output) {
    if (!isOn() || progress.seconds < due_) return;
    const Stopwatch time;
    const auto image = std::make_shared<const FilmImage>(output.develop(film.totals()));
    display_->show(image);
    due_ = progress.seconds + std::max(secondsBetweenImages, time.seconds() / shareForImages);
}

void Watching::showLast(const FilmImage& image) {
    if (isOn()) display_->show(std::make_shared<const FilmImage>(image));
}

}  // namespace eikonal
