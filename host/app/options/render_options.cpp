// The options of render.

#include "app/options/declare.h"
#include "app/options/parser.h"
#include "app/options/shared_options.h"

#include <iterator>

namespace eikonal {
namespace {

void addOutput(CLI::App* app, Options& o) {
    OutputOptions& out = o.output;
    const std::string group = imageGroup;
    addImageFiles(app, out);
    addAov(app, out)->group(group);
    app->add_flag("--denoise", out.denoise,
                  "Remove noise with Intel Open Image Denoise, if it is installed; an EXR keeps the noisy image in the layer noisy")
        ->group(group);
    value(app, "--time-limit", out.timeLimit, "TIME", "Stop rendering after this time, but not before every pixel has a sample",
          parseDuration)
        ->group(group);
    value(app, "--deadline", out.deadline, "TIME",
          "End at this time after the start of the program: loading, compiling and writing count, too", parseDuration)
        ->group(group);
    value(app, "--target-error,--max-error", out.targetError, "E",
          "Sample adaptively until the image's error is about E, such as 0.05 or 5%; --spp is then the maximum per pixel", parseShare)
        ->group(group);
    value(app, "--error-metric", out.errorMetric, "NAME",
          "What the error is: relmse-root (default): relative to each pixel; relmse-scaled: the same, however bright the image is; "
          "mse-root: absolute; nrmse: relative to the image's mean",
          oneOf<ErrorMetric>({std::begin(errorMetricNames), std::end(errorMetricNames)}))
        ->group(group);
    app->add_flag("--skip-existing", out.skipExisting, "Leave out what has its whole image already")->group(group);
    app->add_flag("--stats", out.stats, "Print time and memory statistics")->group(group);
    app->add_flag("--json", o.json, "Print one line of JSON at the end: files, samples, times, warnings")->group(group);
}

void addCheckpoints(CLI::App* app, OutputOptions& out) {
    const std::string group = partsGroup;
    app->add_option("--checkpoint", out.checkpoint, "Keep what is rendered in this file, at intervals and however the render ends")
        ->type_name("FILE")
        ->group(group);
    value(app, "--samples", out.samples, "A:B|K/M",
          "Render only samples A <= i < B of each pixel, or part K of M parts of them; merge joins them", parseSamples)
        ->group(group);
    value(app, "--tile", out.tile, "I/N", "Render only part I of N parts of the image; merge joins them", parseTile)->group(group);
    addTilesBy(app, out);
    addCheckpointInterval(app, out);
    app->add_flag("--resume", out.resume, "Go on from the checkpoint, if it is there")->group(group);
    app->add_flag("--write-partial-images", out.partialImages, "Write the image at the same intervals, also without a checkpoint")
        ->group(group);
}

void addWatching(CLI::App* app, WatchOptions& watch) {
    const std::string group = "Watching a render";
    auto* view = app->add_flag("--view", watch.page, "Show the image, while it is rendered, on a page in a browser; prints its address");
    view->group(group);
    value(app, "--port", watch.port, "N", "The page's port (default: one that is free)", integer(1, 65535))->group(group)->needs(view);
    app->add_option("--view-address", watch.address,
                    "The address of this machine that serves the page (default: 127.0.0.1, for this machine alone)")
        ->type_name("ADDRESS")
        ->group(group)
        ->needs(view);
    app->add_flag("--view-wait", watch.waits, "Keep the page after the render, until it is told to end")->group(group)->needs(view);
    value(app, "--display-server", watch.display, "HOST:PORT", "Show the image, while it is rendered, in a program with tev's protocol",
          parseDisplayAddress)
        ->group(group);
}

}  // namespace

void declareRender(Parser& parser) {
    Options& options = parser.options;
    auto* render = parser.add("render", Command::render, "Render a scene into an image file");
    render
        ->add_option("SCENE", options.scenes,
                     "A pbrt-v4 scene (.pbrt) or a Wavefront OBJ (.obj), also compressed (.gz); -: a pbrt-v4 scene from standard input")
        ->type_name("");
    addScene(render, options, false);
    addFrames(render, options);
    addOutput(render, options);
    addCheckpoints(render, options.output);
    addWatching(render, options.watch);
    addDevice(render, options);
    addLogging(render, options);
    value(render, "--progress", options.progress, "FORM",
          "How to show progress on standard error: auto (default): a bar on a terminal, otherwise plain lines; bar; plain; json: one "
          "object a line; openjd: lines of Open Job Description",
          oneOf<ProgressForm>({{"auto", ProgressForm::automatic},
                               {"bar", ProgressForm::bar},
                               {"plain", ProgressForm::plain},
                               {"json", ProgressForm::json},
                               {"openjd", ProgressForm::openjd}}));
}

}  // namespace eikonal
