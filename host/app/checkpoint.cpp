#include "app/checkpoint.h"

#include "film/stored_scene.h"
#include "image/atomic_file.h"
#include "render/render_identity.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace eikonal {

Checkpoints::Checkpoints(const Options& options, Diagnostics& diagnostics) : options_(options), diagnostics_(diagnostics) {
    const OutputOptions& out = options.output;
    path_ = out.checkpoint;
    if (out.checkpoint.empty()) return;
    removeAbandonedFiles(out.checkpoint);
    checkFileWritable(out.checkpoint, 0);
    std::error_code error;
    if (!std::filesystem::exists(out.checkpoint, error)) return;
    if (!out.resume)
        throw UsageError(
            fmt::format("{}: \"{}\" is there already; add --resume to go on from it, or remove it",
                        std::ranges::count(out.files, out.checkpoint) > 0 ? "-o" : "--checkpoint", out.checkpoint));
    before_ = std::make_unique<FilmFileReader>(out.checkpoint);
    planned_ = before_->head().planned;
    secondsBefore_ = before_->head().seconds;
    own_ = stampOf(out.checkpoint);
}

std::optional<int> Checkpoints::samplesLaidOutFor() const {
    if (!before_) return {};
    return identityFromJson(before_->head().identity, before_->path()).samples;
}

void Checkpoints::resume(const Session& session, Film& film, RenderOutput& output) {
    if (path_.empty()) return;
    const RenderIdentity here = identityOf(session, options_, film);
    head_.identity = toJson(here);
    head_.scene = toJson(session.packed(), session.wholePixels(), session.scene().film);
    head_.metadata = toJson(output.metadata());
    if (!before_) return;
    const RenderIdentity there = identityFromJson(before_->head().identity, path_);
    if (const std::vector<std::string> found = differences(here, there, path_); !found.empty())
        throw Error(ExitCode::scene, fmt::format("{}: cannot go on from it, because it is of another render:\n  {}", path_,
                                                 fmt::join(found, "\n  ")));
    if (here.device != there.device)
        diagnostics_.warn({}, fmt::format("{} was rendered by \"{}\"; this is \"{}\", whose samples may differ in their last bits", path_,
                                          there.device, here.device));
    before_->readInto(film);
    before_.reset();
}

void Checkpoints::pause(const Film& film, std::span<const unsigned> planned, double seconds, RenderOutput& output) {
    const OutputOptions& out = options_.output;
    if ((!out.checkpoint.empty() || out.partialImages) && sinceLast_.seconds() >= out.checkpointEvery)
        writeAll(film, planned, seconds, output);
}

std::string Checkpoints::writeAll(const Film& film, std::span<const unsigned> planned, double seconds, RenderOutput& output) {
    std::string problem;
    try {
        save(film, planned, seconds);
        const FilmTotals totals = film.totals();
        output.writeSoFar(output.develop(totals), output.report(totals, secondsBefore_ + seconds).metadata);
    } catch (const Error& error) {
        problem = error.what();
        diagnostics_.warn({}, fmt::format("{}; rendering goes on", problem));
    }
    sinceLast_ = {};
    return problem;
}

void Checkpoints::save(const Film& film, std::span<const unsigned> planned, double seconds) {
    if (path_.empty()) return;
    if (stampOf(path_) != own_) {
        const std::string other = nameBeside(path_);
        diagnostics_.warn({}, fmt::format("{}: another program has written it since this render began; the checkpoint is {}", path_,
                                          other));
        path_ = other;
    }
    head_.planned.assign(planned.begin(), planned.end());
    head_.seconds = secondsBefore_ + seconds;
    writeFilmFile(path_, film, head_);
    own_ = stampOf(path_);
}

}  // namespace eikonal
