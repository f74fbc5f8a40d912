#pragma once
// The command line. Each option is declared once, in options/, with its help text and its range check.

#include "app/presets.h"
#include "app/render_place.h"
#include "app/wish.h"
#include "film/noise.h"
#include "film/sample_nodes.h"
#include "film/tile.h"
#include "image/image_encoding.h"
#include "messages.h"
#include "render/options.h"
#include "view/options.h"

#include <optional>
#include <string>
#include <vector>

namespace eikonal {

enum class Command { print, render, info, bench, trade, cache, listDevices, compare, denoise, merge, submit, compileKernels };

struct OutputOptions {
    std::vector<std::string> files;                   ///< empty: the scene's name with .exr
    Aovs aovs;
    ImageEncoding encoding;
    bool denoise = false;
    std::optional<double> timeLimit;                  ///< seconds of rendering
    std::optional<double> deadline;                   ///< seconds from the start of the program until the files are written
    std::optional<double> targetError;                ///< target of adaptive sampling, > 0
    ErrorMetric errorMetric = ErrorMetric::relmseRoot;
    bool stats = false;
    std::string checkpoint;                           ///< a file; empty: none
    double checkpointEvery = 300;                     ///< seconds
    bool resume = false;                              ///< go on from the checkpoint, if it is there
    bool hasImage = true;                             ///< false: only the film is kept
    std::optional<SampleSelection> samples;           ///< of each pixel, within those of --spp
    std::optional<Tile> tile;
    TilesBy tilesBy = TilesBy::rows;
    bool partialImages = false;                       ///< write the image each time that a checkpoint is due
    bool skipExisting = false;                        ///< what has its whole image is not rendered
};

struct FarmEngine;

struct SubmitOptions {
    const FarmEngine* engine = nullptr;               ///< not null once parsed
    int tiles = 1, sampleRanges = 1, framesPerTask = 1;
    std::string folder;                               ///< empty: the scene's name and the engine's
    bool isDryRun = false;
};

struct Options : SessionOptions {
    Command command = Command::print;
    std::string text;                                 ///< what Command::print prints
    std::string commandLine;                          ///< as the user gave it
    bool quiet = false;
    ProgressForm progress = ProgressForm::automatic;
    std::string logFile;                              ///< empty: none
    const Preset* preset = nullptr;                   ///< --quality; its options are among the others. Null: none
    OutputOptions output;
    WatchOptions watch;
    bool json = false;                                ///< info, compare, render: print JSON
    std::vector<std::string> parts;                   ///< merge
    bool isPartial = false;                           ///< merge: samples may be missing
    std::string jsonFile;                             ///< bench: if not empty, write JSON there
    bool loop = false;                                ///< bench
    bool efficiency = false;                          ///< bench: each repeat has its own seed
    int repeats = 5;                                  ///< bench
    bool clearCache = false, warmCache = false;       ///< cache
    std::vector<std::string> scenes;                  ///< render, cache --warm; scene.path is the first
    std::vector<int> frames;                          ///< render, submit: of each scene, each once; empty: scenes are no animations
    RenderPlace place;                                ///< render: of one job
    std::string image;                                ///< compare, denoise
    std::string reference;                            ///< compare; bench: a converged image, empty: none
    bool scatter = false;                             ///< compare: ignore the image's variance channel
    std::string heatMap;                              ///< compare: if not empty, write the map of FLIP there
    std::optional<double> failAbove;                  ///< compare: the largest mean of FLIP that is no failure
    CompileRequest compile;
    double budget = 300;                              ///< trade: seconds
    std::vector<Wish> wishes;                         ///< trade
    bool compilerFlags = false;                       ///< trade: also try flags that are not strict
    SubmitOptions submit;
    std::vector<std::string> passedOn;                ///< trade, submit: their options that `render` has, "--name=value"
    std::vector<std::string> passedToMerge;           ///< submit: its options that `merge` has, but for -o
    std::vector<std::string> passedToFrames;          ///< submit: those of animations, but for --frames
};

/// Parses the command line. `arguments` begins with the program's name. Throws a UsageError that says what would have worked.
Options parseOptions(const std::vector<std::string>& arguments);

/// The long names of all options of all commands, for the test that compares them with docs/command-line.md.
std::vector<std::string> allOptionNames();

}  // namespace eikonal
