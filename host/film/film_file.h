#pragma once
// A film on disk, as it is in the middle of a render: every word of every pixel, and the samples that it has.

#include "film/film.h"
#include "film/record_file.h"

#include <memory>
#include <string>
#include <vector>

namespace eikonal {

/// What a film file holds besides pixels.
struct FilmFileHead {
    std::string identity;            ///< what was rendered, and how: JSON (render/render_identity.h)
    std::vector<unsigned> planned;   ///< RenderControl::planned
    double seconds = 0;              ///< of rendering so far
};

/// Replaces a film file, completely or not at all. Throws what AtomicFile throws.
void writeFilmFile(const std::string& path, const Film& film, const FilmFileHead& head);

/// Throws Error (ExitCode::scene), "path: what is wrong", for files that are truncated, damaged or something else.
class FilmFileReader {
public:
    explicit FilmFileReader(const std::string& path);
    const std::string& path() const { return records_.path(); }
    const FilmFileHead& head() const { return head_; }
    /// Puts the file's pixels into a film, all of which must be there, with as many words.
    void readInto(Film& film) const;

private:
    RecordReader records_;
    FilmFileHead head_;
};

}  // namespace eikonal
