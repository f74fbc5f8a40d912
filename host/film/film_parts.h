#pragma once
// Films of parts of an image, and of ranges of its samples, as the one film that they are together.

#include "film/film_file.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace eikonal {

class FilmParts {
public:
    /// Opens the files. layout: of their pixels' words. isPartial: samples may be missing between others. Throws what FilmFileReader
    /// throws.
    FilmParts(std::vector<std::unique_ptr<FilmFileReader>> files, const QueueLayout& layout, const PixelRect& pixels, bool isPartial);

    /// Calls `take` for the pixels of row y from left to right, with all their samples joined. Holds a few rows of pixels at a time. Throws
    /// an Error that names the files for samples that two of them have, and for missing ones: samples before other samples of the same
    /// pixel, or before `end`, or whole pixels.
    void forRuns(int y, unsigned end, const std::function<void(const FilmRun&)>& take);

private:
    /// A run of one of the files.
    struct Place {
        const FilmFileReader* file;
        RecordReader::Record record;
        FilmRun head;               ///< without words
    };
    struct Node { SampleRange range; const Place* place; size_t index; };   ///< node number `index` of a run
    FilmRun joined(int y, int x0, int x1, const std::vector<Node>& nodes) const;
    void checkGap(const FilmRun& run, unsigned end) const;

    std::vector<std::unique_ptr<FilmFileReader>> files_;
    size_t words_;
    JoinedSums sums_;
    PixelRect pixels_;
    bool isPartial_;
    std::vector<std::vector<Place>> rows_;
};

}  // namespace eikonal
