#pragma once
// The error of an image against a reference while it is rendered: pbrt-v4's options "msereferenceimage" and "msereferenceout".

#include "app/render_output.h"
#include "film/film.h"

#include <fstream>
#include <string>

namespace eikonal {

class ErrorLog {
public:
    /// Reads the reference and begins the file, if the film names both. Throws Error (ExitCode::scene) if it cannot.
    explicit ErrorLog(const FilmDescription& film);

    /// Adds a line, "samples error", if every pixel has more samples than at the last call. The error is the mean squared difference
    /// of the colour channels over the pixels that both images have. Throws Error if they share no pixel, or differ in size.
    void note(unsigned samples, const Film& film, const RenderOutput& output);

private:
    FilmImage reference_;
    std::ofstream file_;
    unsigned last_ = 0;
};

}  // namespace eikonal
