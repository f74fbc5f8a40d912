#include "app/error_log.h"

#include "error.h"
#include "image/compare.h"
#include "image/image_file.h"

#include <fmt/format.h>

namespace eikonal {

ErrorLog::ErrorLog(const FilmDescription& film) {
    if (film.errorReference.empty()) return;
    reference_ = readImage(film.errorReference).image;
    file_.open(film.errorLog);
    if (!file_) throw Error(ExitCode::scene, fmt::format("cannot write \"{}\": it cannot be opened", film.errorLog));
}

/// The mean squared difference of the pixels that both images have.
static double meanSquare(const FilmImage& image, const FilmImage& reference) {
    const PixelBounds part = sharedPixels(image, reference);
    double sum = 0;
    for (int y = part.y0; y < part.y1; ++y)
        for (int x = part.x0; x < part.x1; ++x) {
            const glm::dvec3 difference = glm::dvec3(image.color[image.index(x, y)]) - glm::dvec3(reference.color[reference.index(x, y)]);
            sum += glm::dot(difference, difference);
        }
    return sum / (3.0 * (part.x1 - part.x0) * (part.y1 - part.y0));
}

void ErrorLog::note(unsigned samples, const Film& film, const RenderOutput& output) {
    if (!file_.is_open() || samples == last_) return;
    last_ = samples;
    file_ << fmt::format("{} {:.9g}\n", samples, meanSquare(output.develop(film.totals()), reference_)) << std::flush;
}

}  // namespace eikonal
