// Checks that concern several options.

#include "app/command_line.h"
#include "app/options/parser.h"
#include "app/output.h"
#include "app/render_jobs.h"
#include "error.h"
#include "image/image_file.h"
#include "image/seed_variance.h"
#include "messages.h"
#include "standard_stream.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace eikonal {

/// The extension of film files.
static constexpr const char* filmExtension = ".film";

static bool writesFilms(Command command) { return command == Command::render || command == Command::merge || command == Command::submit; }

void chooseFilm(Options& o) {
    OutputOptions& out = o.output;
    if (!writesFilms(o.command)) return;
    const auto isFilm = [](const std::string& file) { return file.ends_with(filmExtension); };
    const auto films = std::ranges::count_if(out.files, isFilm);
    if (films + !out.checkpoint.empty() > 1) throw UsageError("-o and --checkpoint name more than one film; one is enough");
    if (films) {
        out.checkpoint = *std::ranges::find_if(out.files, isFilm);
        std::erase_if(out.files, isFilm);
    }
    out.hasImage = !out.files.empty() || (!films && !out.samples && !out.tile && o.command != Command::merge);
}

/// Checks that concern parts of an image.
static void checkParts(const Options& o) {
    const OutputOptions& out = o.output;
    if (o.command == Command::merge && o.parts.empty()) throw UsageError("merge needs parts: eikonal merge a.film b.film -o image.exr");
    if (o.command == Command::merge && !out.hasImage && out.checkpoint.empty())
        throw UsageError("merge needs a file to write: -o image.exr, or -o all.film for a larger part");
    if (out.tilesBy == TilesBy::cost && (o.command == Command::submit ? o.submit.tiles == 1 : !out.tile))
        throw UsageError("--tiles-by is of parts of the image; say how many: --tile 1/8, or --tiles 8 with submit");
    if (!out.samples && !out.tile) return;
    if (out.checkpoint.empty()) throw UsageError("--samples and --tile render a part, which merge joins to others; keep it: -o part.film");
    if (out.targetError)
        throw UsageError("--max-error decides by the whole image and all samples, so it goes with neither --samples nor --tile");
}

void chooseFrames(Options& o) {
    if (!o.scene.turntable || !o.frames.empty()) return;
    o.frames.resize(static_cast<size_t>(*o.scene.turntable));
    std::iota(o.frames.begin(), o.frames.end(), 0);
}

/// Checks that concern frames.
static void checkFrames(const Options& o) {
    const SceneOptions& scene = o.scene;
    if (scene.fps && o.frames.empty()) throw UsageError("--fps is of frames; say which: --frames 1-10");
    if (scene.shutter && !scene.fps) throw UsageError("--shutter is a share of a frame of --fps; give both: --fps 24 --shutter 0.5");
    if (scene.fps && scene.turntable) throw UsageError("--fps is for pbrt scenes and --turntable for OBJ files; give one of them");
    if (o.output.skipExisting && !o.output.hasImage) throw UsageError("--skip-existing looks for images; films go on with --resume");
    if (o.output.skipExisting && o.output.files.empty())
        throw UsageError("--skip-existing looks for the images that -o names; add it: -o image.exr");
}

/// Checks that concern jobs of frames.
static void checkSubmittedFrames(const Options& o) {
    const SubmitOptions& s = o.submit;
    if (s.framesPerTask > 1 && o.frames.empty()) throw UsageError("--frames-per-task is of frames; say which: --frames 1-48");
    if (o.frames.empty()) return;
    if (s.tiles > 1 || s.sampleRanges > 1)
        throw UsageError("the parts of an animation are its frames; leave --tiles and --sample-ranges away, or submit a frame alone");
    if (!o.output.hasImage) throw UsageError("each frame is an image; name it: -o image.####.exr, or -o FOLDER/");
    if (o.output.files.empty()) throw UsageError("submit needs to know where the frames go: -o image.####.exr, or -o FOLDER/");
}

/// Each image is to be of a format, and options of images are to have one.
static void checkFormats(const Options& o) {
    if (o.command == Command::trade) return;  // -o is a page
    const auto check = [](const std::string& option, const std::string& file, const ImageEncoding& encoding, const char* more) {
        const std::string problem = isFolder(file) ? "" : unknownFormat(file, encoding);
        if (!problem.empty()) throw UsageError(fmt::format("{} {}: cannot write it: {}{}", option, file, problem, more));
    };
    for (const std::string& file : o.output.files)
        if (!isStandardStream(file)) check("-o", file, o.output.encoding, writesFilms(o.command) ? ", and film for a part" : "");
    if (!o.heatMap.empty()) check("--heat-map", o.heatMap, {}, "");
    const bool areNamed = std::ranges::none_of(o.output.files, [](const std::string& file) { return isFolder(file); });
    const bool makesNoImage = !o.output.hasImage && writesFilms(o.command);
    if ((!o.output.files.empty() && areNamed) || makesNoImage)
        checkEncoding(imageFiles(o.output.files, o.output.encoding), o.output.encoding);
    if (makesNoImage && o.output.denoise)
        throw UsageError("--denoise is of images, and only a film is written; add an image: -o image.exr, or give it to merge");
    if (makesNoImage && o.output.partialImages)
        throw UsageError("--write-partial-images is of images, and only a film is written; add an image: -o image.exr");
}

/// Standard output holds one thing.
static void checkStandardStreams(const Options& o) {
    const OutputOptions& out = o.output;
    const bool writesImage = o.command == Command::render || o.command == Command::merge || o.command == Command::denoise;
    const bool rendersElsewhere = o.command == Command::trade || o.command == Command::submit;
    if (rendersElsewhere && isStandardStream(o.scene.path))
        throw UsageError("the scene is read several times, and standard input can be read once; name a file");
    if (o.command == Command::submit && std::ranges::any_of(out.files, isStandardStream))
        throw UsageError("other machines write the image, and have another standard output; name a file");
    if (!writesImage || std::ranges::none_of(out.files, isStandardStream)) return;
    if (out.encoding.format.empty()) throw UsageError("`-o -` has no name that would tell the format; add it: -o - --format exr");
    if (std::ranges::count_if(out.files, isStandardStream) > 1) throw UsageError("standard output holds one image; write `-o -` once");
    if (out.stats || o.json)
        throw UsageError(
            fmt::format("the image and {} would both go to standard output; give -o a file", out.stats ? "--stats" : "--json"));
    if (out.partialImages)
        throw UsageError("--write-partial-images writes the image several times, and standard output holds one; give -o a file");
}

bool isGiven(const CLI::App* command, const std::string& name) {
    const CLI::Option* option = command->get_option_no_throw(name);
    return option && option->count() > 0;
}

void checkTogether(const Parser& parser, const CLI::App* command) {
    const Options& o = parser.options;
    const bool needsScene = o.command == Command::render || o.command == Command::info || o.command == Command::bench ||
                            o.command == Command::trade || o.command == Command::submit;
    if (needsScene && o.scene.path.empty())
        throw UsageError(fmt::format("{0} needs a scene: eikonal {0} scene.pbrt\n{1}", command->get_name(), getHelp));
    if (command->get_name() == "completion" && !std::ranges::count(completionShells, parser.shell))
        throw UsageError(fmt::format("completion needs the name of a shell, {}: eikonal completion bash\n{}",
                                     fmt::join(completionShells, ", "), getHelp));
    if (o.command == Command::submit && !o.submit.engine)
        throw UsageError(fmt::format("submit needs to know what runs the parts: --engine slurm, openjd or kubernetes\n{}", getHelp));
    if (o.command == Command::compare && o.reference.empty())
        throw UsageError(fmt::format("compare needs two images: eikonal compare image.exr reference.exr\n{}", getHelp));
    if (o.command == Command::denoise && o.image.empty())
        throw UsageError(fmt::format("denoise needs an image: eikonal denoise image.exr -o clean.exr\n{}", getHelp));
    if (o.command == Command::cache && !o.scenes.empty() && !o.warmCache)
        throw UsageError(fmt::format("cache takes scenes only with --warm: eikonal cache --warm {}\n{}", o.scenes.front(), getHelp));
    if (o.command == Command::cache && o.warmCache && !o.device.cache)
        throw UsageError(fmt::format("--warm keeps kernels and --no-cache keeps none; give one of them\n{}", getHelp));
    if (o.command == Command::bench && !o.reference.empty() && !o.efficiency)
        throw UsageError("--reference needs --efficiency: without it, bench measures no error");
    if (o.efficiency && o.repeats < SeedVariance::leastSeeds)
        throw UsageError(fmt::format("--efficiency measures the variance between repeats; --repeats must be at least {}, not {}",
                                     SeedVariance::leastSeeds, o.repeats));
    checkParts(o);
    checkFrames(o);
    if (o.command == Command::submit) checkSubmittedFrames(o);
    checkStandardStreams(o);
    checkFormats(o);
    const bool writesAtIntervals = !o.output.checkpoint.empty() || o.output.partialImages || o.command == Command::submit;
    if (isGiven(command, "--checkpoint-every") && !writesAtIntervals)
        tell(LogLevel::warning,
             "--checkpoint-every has no effect here; name a checkpoint, --checkpoint FILE, or add --write-partial-images", o.log);
    if (o.output.resume && o.output.checkpoint.empty())
        throw UsageError("--resume goes on from a checkpoint; name it: --checkpoint FILE --resume");
    if (o.scene.cropWindow && o.scene.pixelBounds)
        throw UsageError("--cropwindow and --pixelbounds both select a part of the image; give one of them");
    if (o.scene.camera && o.scene.lookAt && *o.scene.camera == *o.scene.lookAt) throw UsageError("--camera and --look-at must differ");
    if (o.scene.up && *o.scene.up == glm::dvec3(0)) throw UsageError("--up must not be 0,0,0");
}

}  // namespace eikonal
