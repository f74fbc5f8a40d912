#pragma once
// A film on disk, as it is in the middle of a render: every word of every pixel, and the samples that it has.

#include "film/film.h"
#include "film/record_file.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace eikonal {

/// What a film file holds besides pixels.
struct FilmFileHead {
    std::string identity;            ///< what was rendered, and how: JSON (render/render_identity.h)
    std::vector<unsigned> planned;   ///< RenderControl::planned
    double seconds = 0;              ///< of rendering so far
    std::string scene;               ///< what developing needs (stored_scene.h)
    std::string metadata;            ///< of the image: JSON
};

/// Pixels x0 <= x < x1 of row y that have the same nodes. Word w of node k of pixel x is
/// words[(k * words per pixel + w) * (x1 - x0) + x - x0].
struct FilmRun {
    int y = 0, x0 = 0, x1 = 0;
    std::vector<SampleRange> nodes;   ///< in order
    std::vector<uint> words;
};

/// Replaces a film file, completely or not at all. The functions throw what AtomicFile's throw.
class FilmFileWriter {
public:
    FilmFileWriter(const std::string& path, const FilmFileHead& head);
    /// Rows from the top, runs from the left.
    void write(const FilmRun& run);
    /// Those rows that have samples. Before the runs or after.
    void write(const SplatSums& splats);
    void commit() { file_.commit(); }

private:
    RecordWriter file_;
};
void writeFilmFile(const std::string& path, const Film& film, const FilmFileHead& head);

/// Throws Error (ExitCode::scene), "path: what is wrong", for files that are truncated, damaged or something else.
class FilmFileReader {
public:
    explicit FilmFileReader(const std::string& path);
    const std::string& path() const { return records_.path(); }
    const FilmFileHead& head() const { return head_; }
    /// Puts the file's pixels into a film, all of which must be there, with as many words.
    void readInto(Film& film) const;

    /// The records of runs, one of them, and one without its words.
    std::vector<RecordReader::Record> pixelRecords() const;
    FilmRun readRun(const RecordReader::Record& record, size_t wordsPerPixel) const;
    FilmRun readHead(const RecordReader::Record& record) const;
    /// Calls `take` for each row of splats.
    void forSplats(const std::function<void(const SplatRow&)>& take) const;

private:
    RecordReader records_;
    FilmFileHead head_;
};

}  // namespace eikonal
