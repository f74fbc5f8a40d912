#include "app/commands.h"
#include "app/output.h"
#include "app/render_output.h"
#include "app/statistics.h"
#include "app/stored_metadata.h"
#include "available_memory.h"
#include "diagnostics.h"
#include "film/film_parts.h"
#include "film/stored_scene.h"
#include "image/image_file.h"
#include "messages.h"
#include "render/render_identity.h"

#include <fmt/format.h>

#include <sys/resource.h>

#include <algorithm>
#include <filesystem>

namespace eikonal {
namespace {

/// Lets the process open as many files as the system allows.
void openManyFiles() {
    struct rlimit limit {};
    if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
    limit.rlim_cur = limit.rlim_max;
    ::setrlimit(RLIMIT_NOFILE, &limit);
}

/// Throws an Error that names every part that is of another render than the first, and why.
void checkSameRender(const std::vector<std::unique_ptr<FilmFileReader>>& files, Diagnostics& diagnostics) {
    const std::string& name = files.front()->path();
    const RenderIdentity first = identityFromJson(files.front()->head().identity, name);
    std::string problems;
    for (const auto& file : files) {
        const RenderIdentity other = identityFromJson(file->head().identity, file->path());
        const std::vector<std::string> found = partDifferences(other, first, name);
        if (!found.empty())
            problems += fmt::format("{}{} is of another render than {}:\n  {}", problems.empty() ? "" : "\n", file->path(), name,
                                    fmt::join(found, "\n  "));
        if (other.device != first.device)
            diagnostics.warnOnce("device", {},
                                 fmt::format("{} was rendered by \"{}\" and {} by \"{}\": samples may differ in their last bits",
                                             file->path(), other.device, name, first.device));
    }
    if (!problems.empty()) throw Error(ExitCode::scene, problems);
}

/// The samples that each pixel is to have: those that the render was laid out for. With adaptive sampling, what is there.
unsigned samplesWanted(const std::vector<std::unique_ptr<FilmFileReader>>& files) {
    const bool isAdaptive = std::ranges::any_of(files, [](const auto& file) { return !file->head().planned.empty(); });
    if (isAdaptive) return 0;
    return static_cast<unsigned>(identityFromJson(files.front()->head().identity, files.front()->path()).samples);
}

/// What the light paths of all parts have added to the image; nothing without light paths.
std::unique_ptr<SplatSums> joinedSplats(const std::vector<std::unique_ptr<FilmFileReader>>& files, const PackedScene& scene) {
    if (!scene.features.has(Feature::LIGHT_PATHS)) return nullptr;
    auto all = std::make_unique<SplatSums>(scene.pixels, scene.features.has(Feature::RENDER_PASSES));
    for (const auto& file : files)
        file->forSplats([&](const SplatRow& row) {
            if (!all->fits(row))
                throw Error(ExitCode::scene, fmt::format("{}: is damaged: its light paths do not fit its image", file->path()));
            if (!all->add(row))
                throw Error(ExitCode::scene, fmt::format("{} has light paths of row {} that another part has, too", file->path(), row.y));
        });
    return all;
}

/// Throws an Error if the image does not fit into memory: a small part may be one of any image.
void checkMemory(const PackedScene& scene, const QueueLayout& layout, const std::string& name) {
    const PixelRect& pixels = scene.pixels;
    const double needed = static_cast<double>(pixels.width()) * pixels.height() *
                          static_cast<double>(sizeof(uint) * static_cast<size_t>(layout.words) + Film::developedBytes(scene));
    const double available = static_cast<double>(availableMemory());
    if (needed <= available) return;
    throw Error(ExitCode::scene,
                fmt::format("{}: its image of {} x {} pixels needs {} of memory, and {} are available; a part, -o ALL.film, needs little",
                            name, pixels.width(), pixels.height(), readableBytes(needed), readableBytes(available)));
}

/// The result would take the place of a part, which no other merge could use any more.
void checkIsNoPart(const std::string& result, const std::vector<std::string>& parts) {
    for (const std::string& part : parts) {
        std::error_code absent;
        if (std::filesystem::equivalent(result, part, absent))
            throw UsageError(fmt::format("-o {} is one of the parts; name another file", result));
    }
}

/// Whether pixels have all of their first `wanted` samples, and none is missing before a later one.
bool hasAll(const FilmRun& run, unsigned wanted) {
    unsigned next = 0;
    for (const SampleRange& node : run.nodes) {
        if (node.first != next) return false;
        next = node.end;
    }
    return next > 0 && next >= wanted;
}

}  // namespace

int mergeCommand(const Options& o) {
    Diagnostics diagnostics(o.log);
    const std::vector<std::string> images = imageFiles(o.output.files, o.output.encoding);
    if (o.output.hasImage) checkEncoding(images, o.output.encoding);
    for (const std::string& file : images) checkIsNoPart(file, o.parts);
    if (!o.output.checkpoint.empty()) checkIsNoPart(o.output.checkpoint, o.parts);
    for (const std::string& file : images) checkWritable(file, 0, o.output.encoding);
    if (!o.output.checkpoint.empty()) checkFileWritable(o.output.checkpoint, 0);
    openManyFiles();
    std::vector<std::unique_ptr<FilmFileReader>> files;
    for (const std::string& part : o.parts) files.push_back(std::make_unique<FilmFileReader>(part));
    checkSameRender(files, diagnostics);

    const FilmFileHead head = files.front()->head();
    const std::string name = files.front()->path();
    const StoredScene scene = storedScene(head.scene, name);
    const PixelRect pixels = scene.packed.pixels;
    const QueueLayout layout = filmLayout(scene.packed.features, scene.packed.frame().bucket_count,
                                          scene.packed.constants.lightGroups);
    if (o.output.hasImage) checkMemory(scene.packed, layout, name);
    const JoinedSums sums(layout);
    const unsigned wanted = samplesWanted(files), end = o.output.hasImage && !o.isPartial ? wanted : 0;
    FilmFileHead merged = head;
    merged.seconds = 0;
    for (const auto& file : files) merged.seconds += file->head().seconds;
    const bool isPartial = o.isPartial || !o.output.hasImage;
    const std::unique_ptr<SplatSums> splats = joinedSplats(files, scene.packed);
    FilmParts parts(std::move(files), layout, pixels, isPartial);

    /* Row by row: into the image's sums, and into a file */
    std::optional<FilmFileWriter> film;
    if (!o.output.checkpoint.empty()) film.emplace(o.output.checkpoint, merged);
    if (film && splats) film->write(*splats);
    const size_t width = static_cast<size_t>(pixels.width()), plane = width * static_cast<size_t>(pixels.height());
    const auto words = o.output.hasImage ? allocatePlanes(pixels, layout.words) : nullptr;
    size_t wholePixels = 0;   // that have all samples
    for (int y = pixels.y0; y < pixels.y1; ++y)
        parts.forRuns(y, end, [&](const FilmRun& run) {
            if (film) film->write(run);
            if (!words) return;
            const size_t count = static_cast<size_t>(run.x1 - run.x0);
            if (hasAll(run, wanted)) wholePixels += count;
            std::vector<PixelRow<const uint>> rows;
            for (size_t node = 0; node < run.nodes.size(); ++node)
                rows.push_back({run.words.data() + node * static_cast<size_t>(layout.words) * count, count});
            uint* const total = &words[static_cast<size_t>(y - pixels.y0) * width + static_cast<size_t>(run.x0 - pixels.x0)];
            sums.joinAll(run.nodes, rows, {total, plane}, count);
        });
    if (film) film->commit();
    std::vector<std::string> written = images;
    if (film) written.push_back(o.output.checkpoint);
    const std::string result =
        fmt::format("merged {} part{} into {}", o.parts.size(), o.parts.size() == 1 ? "" : "s", fmt::join(written, " and "));
    if (!o.output.hasImage) {
        tellResult(result, o.log);
        return static_cast<int>(ExitCode::success);
    }

    const FilmTotals totals(scene.packed, layout, words, splats.get());
    StoredMetadata stored = storedMetadata(head.metadata, name);
    const ErrorEstimate error = totals.error(stored.metric);
    Metadata& metadata = stored.metadata;
    describeFilm(metadata, totals.samples(), error, stored.metric);
    if (wholePixels != plane) metadata.partial = fmt::format("{} of {} pixels have all samples", wholePixels, plane);
    metadata.renderSeconds = merged.seconds;
    metadata.commandLine = o.commandLine;
    tellResult(describe(error, stored.metric), o.log);
    const FilmImage image = developImage(totals, scene.packed, scene.film, stored.aovs, o.output.encoding);
    tellFireflies(metadata, image, o.log);
    warnOfClamping(image, o.output.encoding, {}, diagnostics);
    for (const std::string& file : images) writeImage(file, image, metadata, o.output.encoding);
    tellResult(result, o.log);
    return static_cast<int>(wholePixels == plane ? ExitCode::success : ExitCode::partialImage);
}

}  // namespace eikonal
