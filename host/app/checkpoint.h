#pragma once
// Checkpoints of a render: files from which it goes on as if it had never ended.

#include "app/render_output.h"
#include "clock.h"
#include "diagnostics.h"
#include "film/film_file.h"
#include "image/file_stamp.h"

#include <memory>
#include <optional>
#include <span>

namespace eikonal {

class Checkpoints {
public:
    /// Opens the checkpoint that --resume goes on from, if there is one. Throws an Error for a file that is damaged or no checkpoint, and
    /// for one that --checkpoint would overwrite.
    Checkpoints(const Options& options, Diagnostics& diagnostics);

    /// The samples per pixel that the render has to be laid out for; nothing: it begins anew.
    std::optional<int> samplesLaidOutFor() const;
    /// Puts what was rendered before into a film. Throws an Error that names each difference if that was another render.
    void resume(const Session& session, Film& film, RenderOutput& output);
    /// RenderControl::planned.
    const std::vector<unsigned>& planned() const { return planned_; }
    double secondsBefore() const { return secondsBefore_; }

    /// Writes checkpoint and images if it is time to. Problems are warnings. seconds: of rendering since this process began.
    void pause(const Film& film, std::span<const unsigned> planned, double seconds, RenderOutput& output);
    /// Writes checkpoint and images now. Returns why that failed, which is a warning; empty: it did not.
    std::string writeAll(const Film& film, std::span<const unsigned> planned, double seconds, RenderOutput& output);
    /// Writes the checkpoint, if there is to be one. Not over a file that another program has put there since: then beside it, with a
    /// warning.
    void save(const Film& film, std::span<const unsigned> planned, double seconds);
    /// Where save() has written to, or is going to.
    const std::string& path() const { return path_; }

private:
    const Options& options_;
    Diagnostics& diagnostics_;
    std::string path_;
    FileStamp own_{};   ///< of what was last read from there or written to it
    std::unique_ptr<FilmFileReader> before_;
    FilmFileHead head_;   ///< of the files to write
    std::vector<unsigned> planned_;
    double secondsBefore_ = 0;
    Stopwatch sinceLast_;
};

}  // namespace eikonal
