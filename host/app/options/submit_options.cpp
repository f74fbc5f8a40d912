// The options of submit.

#include "app/farm/job.h"
#include "app/frame_numbers.h"
#include "app/options/declare.h"
#include "app/options/parser.h"
#include "app/options/shared_options.h"

namespace eikonal {

/// How many parts, and who makes them.
static void addFarm(CLI::App* app, SubmitOptions& s) {
    std::vector<std::pair<const char*, const FarmEngine*>> engines;
    for (const FarmEngine& engine : farmEngines()) engines.emplace_back(engine.name, &engine);
    value(app, "--engine", s.engine, "NAME", "What runs the parts: slurm, openjd or kubernetes", oneOf<const FarmEngine*>(engines));
    value(app, "--tiles", s.tiles, "N", "Parts of the image (default: 1)", integer(1, 1 << 20));
    value(app, "--sample-ranges", s.sampleRanges, "M", "Parts of each pixel's samples (default: 1)", integer(1, 1 << 20));
    value(app, "--frames-per-task", s.framesPerTask, "N", "With --frames: how many a task renders, one after the other (default: 1)",
          integer(1, mostFrames));
    app->add_option("--folder", s.folder, "The job's files, parts and messages (default: the scene's name and the engine's)")
        ->type_name("DIR");
    app->add_flag("--dry-run", s.isDryRun, "Only write the folder, and print what would hand the job over");
}

void declareSubmit(Parser& parser) {
    Options& options = parser.options;
    auto* submit = parser.add("submit", Command::submit, "Hand an image over to a render farm, in parts, or an animation");
    addFarm(submit, options.submit);
    addScene(submit, options);
    addImageFiles(submit, options.output);
    addFrames(submit, options);
    addAov(submit, options.output)->group(partsGroup);
    addTilesBy(submit, options.output);
    addCheckpointInterval(submit, options.output);
    addDevice(submit, options);
    addLogging(submit, options);
}

}  // namespace eikonal
