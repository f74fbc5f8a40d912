#include "app/options.h"

#include "image/seed_variance.h"
#include "kinds/integrator_kind.h"
#include "app/command_line.h"
#include "app/farm/job.h"
#include "app/option_values.h"
#include "app/pbrt_spelling.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <sstream>

namespace eikonal {
namespace {

constexpr int unlimited = std::numeric_limits<int>::max();
constexpr const char *sceneGroup = "Scene (overrides the file)", *objGroup = "Camera of an OBJ", *deviceGroup = "Device",
                     *imageGroup = "Image", *partsGroup = "Checkpoints and parts";
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Lets completion offer `words`, which are kept as the name of a validator that accepts everything.
CLI::Option* offer(CLI::Option* option, const std::vector<std::string>& words) {
    CLI::Validator keeper([](std::string&) { return std::string(); }, "");
    return option->check(keeper.name(fmt::format("{}", fmt::join(words, " "))));
}

/// Declares an option whose value is read by `parse(option, text)`.
template <class Target, class Parse>
CLI::Option* value(CLI::App* app, const std::string& names, Target& target, const std::string& type, const std::string& help, Parse parse) {
    const std::string option = names.substr(names.rfind("--"));
    CLI::Option* declared = app->add_option_function<std::string>(
        names, [&target, option, parse](const std::string& text) { target = parse(option, text); }, help);
    if constexpr (requires { parse.words(); }) offer(declared, parse.words());
    return declared->type_name(type);
}

auto integer(int low, int high = unlimited) {
    return [=](const std::string& option, const std::string& text) { return parseInteger(option, text, low, high); };
}
auto number(double low, double high = infinity) {
    return [=](const std::string& option, const std::string& text) { return parseNumber(option, text, low, high); };
}
auto numberFrom(double low, double high = infinity) {
    return [=](const std::string& option, const std::string& text) { return parseNumberFrom(option, text, low, high); };
}
template <class Value> struct OneOf {
    std::vector<std::pair<const char*, Value>> names;
    Value operator()(const std::string& option, const std::string& text) const { return parseName(option, text, names); }
    std::vector<std::string> words() const {
        std::vector<std::string> all;
        for (const auto& [name, value] : names) all.emplace_back(name);
        return all;
    }
};
template <class Value> OneOf<Value> oneOf(std::vector<std::pair<const char*, Value>> names) { return {std::move(names)}; }

void addLogging(CLI::App* app, Options& o) {
    app->add_flag("--quiet", o.quiet, "Print nothing but errors");
    value(app, "--log-level", o.log, "LEVEL", "What to print: silent, error, warning (default), info, debug",
          oneOf<LogLevel>({{"silent", LogLevel::silent},
                           {"error", LogLevel::error},
                           {"warning", LogLevel::warning},
                           {"info", LogLevel::info},
                           {"debug", LogLevel::debug},
                           {"verbose", LogLevel::debug},   // pbrt's names for the ends
                           {"fatal", LogLevel::error}}));
    app->add_option("--log-file", o.logFile, "Also append messages to this file, with the time, as at --log-level info")->type_name("FILE");
}

CLI::Option* addListDevices(CLI::App* app, Options& o) {
    return app->add_flag("--list-devices", o.device.list, "Print the OpenCL devices");
}

void addDevice(CLI::App* app, Options& o) {
    DeviceOptions& d = o.device;
    const std::string group = deviceGroup;
    app->add_option("--device", d.device,
                    "The OpenCL device: its number in list-devices, or part of its name (default: a GPU if there is one)")
        ->type_name("NAME|INDEX")
        ->group(group);
    value(app, "--nthreads", d.threads, "N", "Threads for loading the scene and, on PoCL, for rendering (default: one per core)",
          integer(1, 4096))
        ->group(group);
    app->add_flag_callback("--no-cache", [&d] { d.cache = false; }, "Compile all kernels, and do not cache them")->group(group);
    app->add_option("--dump-kernels", d.dumpFolder, "Write the source and build options of each kernel into this folder")
        ->type_name("DIR")
        ->group(group);
    value(app, "--wave-paths", d.wavePaths, "N", "Paths in flight at once; affects speed and memory, never the image", integer(1, 1 << 26))
        ->group(group);
    value(app, "--local-size", d.localSize, "N", "Work-items per group, a power of two; affects speed, never the image", parsePowerOfTwo)
        ->group(group);
    value(app, "--items-per-work-item", d.itemsPerWorkItem, "N",
          "Neighbouring queue slots per work-item, a power of two; affects speed, never the image", parsePowerOfTwo)
        ->group(group);
    addListDevices(app, o)->group(group);
    value(app, "--contraction", d.contraction, "on|off", "Whether a*b+c may become a fused multiply-add (default: on)",
          oneOf<bool>({{"on", true}, {"off", false}}))
        ->group(group);
    app->add_option_function<std::vector<std::string>>(
           "--math-flags", [&d](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) d.mathFlags.push_back(parseStageFlags("--math-flags", text));
           },
           fmt::format("Flags for the arithmetic of a stage (default: all stages) instead of {}; may be repeated", shippedMathFlags))
        ->type_name("[STAGE:]FLAGS")
        ->type_size(1)
        ->allow_extra_args(false)
        ->group(group);
    app->add_option("--build-options", d.buildOptions,
                    "Additional options for the OpenCL compiler, such as --build-options=-cl-fast-relaxed-math")
        ->type_name("TEXT")
        ->group(group);
}

const std::vector<std::pair<const char*, const IntegratorKind*>>& integratorNames() {
    static const auto names = [] {
        std::vector<std::pair<const char*, const IntegratorKind*>> all;
        for (const IntegratorKind* kind : integratorKindList()) all.emplace_back(kind->name, kind);
        all.emplace_back(volpathAlias, &volpath_integrator);
        return all;
    }();
    return names;
}

/// "a, b, c".
std::string listOf(const std::vector<std::pair<const char*, const IntegratorKind*>>& names) {
    std::string list;
    for (const auto& [name, kind] : names) list += (list.empty() ? "" : ", ") + std::string(name);
    return list;
}

/// `takesOne`: the command takes a single scene.
void addScene(CLI::App* app, Options& o, bool takesOne = true) {
    SceneOptions& s = o.scene;
    if (takesOne)
        app->add_option("SCENE", s.path, "A pbrt-v4 scene (.pbrt) or a Wavefront OBJ (.obj), also compressed (.gz)")->type_name("");
    const std::string group = sceneGroup;
    value(app, "--spp", s.spp, "N", "Samples per pixel", integer(1))->group(group);
    std::vector<std::pair<const char*, const Preset*>> qualities;
    for (const Preset& preset : presets) qualities.emplace_back(preset.name, &preset);
    value(app, "--quality", o.preset, "NAME", "Options that go together: draft, preview, final or reference; other options override them",
          oneOf<const Preset*>(qualities))
        ->group(group);
    value(app, "--seed", s.seed, "N", "Seed of the random numbers", integer(std::numeric_limits<int>::min()))->group(group);
    value(app, "--sampler", s.sampler, "NAME",
          "Random numbers: independent; paddedsobol: low discrepancy in each dimension; sobol: also over several dimensions together; "
          "zsobol (default): also between neighbouring pixels",
          oneOf<SamplerKind>({std::begin(samplerNames), std::end(samplerNames)}))
        ->group(group);
    value(app, "--color", s.colorMode, "NAME",
          "rgb; spectral: four wavelengths per path; auto (default): spectral where the scene needs it",
          oneOf<ColorMode>({{"auto", ColorMode::automatic}, {"rgb", ColorMode::rgb}, {"spectral", ColorMode::spectral}}))
        ->group(group);
    value(app, "--integrator", s.integrator, "NAME",
          "Light transport algorithm: " + listOf(integratorNames()),
          oneOf<const IntegratorKind*>(integratorNames()))
        ->group(group);
    value(app, "--subsurface", s.subsurface, "NAME",
          "Light transport inside bodies of material \"subsurface\": diffusion, or randomwalk (slower, exact)",
          oneOf<SubsurfaceMethod>({std::begin(subsurfaceMethodNames), std::end(subsurfaceMethodNames)}))
        ->group(group);
    value(app, "--max-depth", s.maxDepth, "N", "Bounces; interfaces between media do not count", integer(0))->group(group);
    value(app, "--roulette", s.roulette, "NAME",
          "Probability that a path of throughput t survives Russian roulette: root: sqrt(t); throughput: t, as in pbrt-v4 (default: chosen "
          "for the scene)",
          oneOf<RouletteRule>({std::begin(rouletteRuleNames), std::end(rouletteRuleNames)}))
        ->group(group);
    value(app, "--roulette-scale", s.rouletteScale, "X",
          "Factor of that probability; larger values give longer paths (1 where --roulette or --roulette-depth is given)",
          number(1e-6, 1e6))
        ->group(group);
    value(app, "--roulette-depth", s.rouletteDepth, "N",
          "Bounces before Russian roulette (4 where --roulette or --roulette-scale is given; pbrt-v4: 1)", integer(0))
        ->group(group);
    value(app, "--light-sampler", s.lightSampler, "NAME",
          "How to choose the light to sample: bvh, power or uniform (default: power for few lights, else bvh)",
          oneOf<LightSampler>({std::begin(lightSamplerNames), std::end(lightSamplerNames)}))
        ->group(group);
    value(app, "--environment-guide", s.environmentGuide, "NAME",
          "Whether to guide light samples of an infinite light without an image: auto (default): in closed scenes; always; never",
          oneOf<EnvironmentGuide>({std::begin(environmentGuideNames), std::end(environmentGuideNames)}))
        ->group(group);
    value(app, "--regularize", s.regularize, "on|off",
          "Whether to widen narrow microfacets behind rough reflections (biased; pbrt's regularize)",
          oneOf<bool>({{"on", true}, {"off", false}}))
        ->group(group);
    value(app, "--max-component-value", s.maxComponentValue, "X",
          "Scale samples down to this value (biased; pbrt's maxcomponentvalue); 0: do not", numberFrom(0))
        ->group(group);
    value(app, "--threshold", s.treeThreshold, "X", "Integrator whitted: rays of a smaller weight are not traced (biased)",
          numberFrom(0, 1))
        ->group(group);
    value(app, "--bundle", s.treeBundle, "N", "Integrator whitted: rays that leave a rough surface, 0 or a power of two",
          [](const std::string& option, const std::string& text) { return parsePowerOfTwoOrZero(option, text, mostTreeRays); })
        ->group(group);
    value(app, "--resolution", s.resolution, "WxH", "Pixels of the whole image", parseResolution)->group(group);
    value(app, "--cropwindow", s.cropWindow, "x0,x1,y0,y1", "Render a part, in fractions of the image", parseCropWindow)->group(group);
    value(app, "--pixelbounds", s.pixelBounds, "x0,x1,y0,y1", "Render a part, in pixels: x0 <= x < x1", parsePixelBounds)->group(group);
    app->add_flag("--strict", s.strict, "Features that are parsed but not rendered are errors instead of warnings")->group(group);
    value(app, "--camera", s.camera, "x,y,z", "Position of the camera (default: chosen to show the model)", parseVector)->group(objGroup);
    value(app, "--look-at", s.lookAt, "x,y,z", "A point at the centre of the image", parseVector)->group(objGroup);
    value(app, "--up", s.up, "x,y,z", "Up direction of the image (default: 0,1,0)", parseVector)->group(objGroup);
    value(app, "--fov", s.fov, "DEGREES", "Field of view along the shorter side", number(0, 180))->group(objGroup);
}

void addToneMapping(CLI::App* app, OutputOptions& out) {
    const std::string group = imageGroup;
    auto* tonemap = value(app, "--tonemap", out.toneMapping.curve, "NAME", "For integer formats: clamp (default), reinhard, filmic",
                          [](const std::string&, const std::string& text) { return toneCurve(text); });
    offer(tonemap, toneCurveNames())->group(group);
    value(app, "--exposure", out.toneMapping.exposure, "STOPS", "For integer formats: 1 is twice as bright", number(-infinity))
        ->group(group);
}

void addImageFiles(CLI::App* app, OutputOptions& out) {
    const std::string group = imageGroup;
    app->add_option("-o,--outfile", out.files,
                    "An image file: exr, hdr, pfm, png, jpg, tif, tga, bmp, webp; may be repeated. A single EXR is accompanied by a PNG; "
                    "film: a part for merge "
                    "(default: the scene's name with .exr)")
        ->type_name("FILE")
        ->type_size(1)
        ->allow_extra_args(false)
        ->group(group);
    addToneMapping(app, out);
}

CLI::Option* addAov(CLI::App* app, OutputOptions& out) {
    std::vector<std::string> channels;
    for (const AovName& each : aovNames) channels.emplace_back(each.name);
    auto* aov = value(app, "--aov", out.aovs, "NAMES",
                      fmt::format("Additional channels of an EXR: {}, separated by commas; or all", fmt::join(channels, ", ")), parseAovs);
    channels.emplace_back("all");
    return offer(aov, channels);
}

CLI::Option* addCheckpointInterval(CLI::App* app, OutputOptions& out) {
    return value(app, "--checkpoint-every", out.checkpointEvery, "TIME", "How often to write the checkpoint and the image (default: 5m)",
                 parseDuration)
        ->group(partsGroup);
}

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
          "What the error is: relmse-root (default): relative to each pixel; mse-root: absolute; nrmse: relative to the image's mean",
          oneOf<ErrorMetric>({std::begin(errorMetricNames), std::end(errorMetricNames)}))
        ->group(group);
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

/// How many parts, and who makes them.
void addFarm(CLI::App* app, SubmitOptions& s) {
    std::vector<std::pair<const char*, const FarmEngine*>> engines;
    for (const FarmEngine& engine : farmEngines()) engines.emplace_back(engine.name, &engine);
    value(app, "--engine", s.engine, "NAME", "What runs the parts: slurm, openjd or kubernetes", oneOf<const FarmEngine*>(engines));
    value(app, "--tiles", s.tiles, "N", "Parts of the image (default: 1)", integer(1, 1 << 20));
    value(app, "--sample-ranges", s.sampleRanges, "M", "Parts of each pixel's samples (default: 1)", integer(1, 1 << 20));
    app->add_option("--folder", s.folder, "The job's files, parts and messages (default: the scene's name and the engine's)")
        ->type_name("DIR");
    app->add_flag("--dry-run", s.isDryRun, "Only write the folder, and print what would hand the job over");
}

/// The commands of the program, bound to the options that they fill in.
struct Parser {
    Options options;
    CLI::App app{"Eikonal renders scenes by path tracing on OpenCL devices.", "eikonal"};
    std::vector<std::pair<CLI::App*, Command>> commands;
    std::string shell;   ///< completion

    CLI::App* add(const std::string& name, Command command, const std::string& help) {
        CLI::App* sub = app.add_subcommand(name, help);
        sub->allow_extras();
        commands.emplace_back(sub, command);
        return sub;
    }

    Parser() {
        app.allow_extras();
        app.set_help_all_flag("--help-all", "Print the options of all commands");
        app.set_version_flag("--version", "eikonal " EIKONAL_VERSION);
        addListDevices(&app, options);
        app.require_subcommand(0, 1);

        auto* render = add("render", Command::render, "Render a scene into an image file");
        addScene(render, options);
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

        auto* info = add("info", Command::info, "Print the contents of a scene, and which features it requires and why");
        addScene(info, options);
        info->add_flag("--json", options.json, "Print JSON");
        addLogging(info, options);

        auto* bench = add("bench", Command::bench, "Measure a scene, stage by stage");
        addScene(bench, options);
        bench->add_flag("--loop", options.loop,
                        "Also measure a single kernel that follows each path in a loop, interleaved with the stages");
        bench->add_flag("--efficiency", options.efficiency,
                        "Also measure efficiency: each repeat has its own seed, and the variance between repeats is the error");
        bench
            ->add_option("--reference", options.reference,
                         "With --efficiency: a converged image that errors are relative to (default: the mean of the repeats)")
            ->type_name("IMAGE");
        value(bench, "--repeats", options.repeats, "N", "Number of renders; the median counts (default: 5)", integer(1, 1000));
        bench->add_option("--json", options.jsonFile, "Also write the figures into this file")->type_name("FILE");
        addDevice(bench, options);
        addLogging(bench, options);

        auto* trade = add("trade", Command::trade, "Measure error and time of a scene under many settings, and recommend some");
        addScene(trade, options);
        trade
            ->add_option("-o,--outfile", options.output.files,
                         "The page; a CSV and a JSON are written beside it (default: SCENE-trade.html)")
            ->type_name("FILE.html")
            ->type_size(1)
            ->allow_extra_args(false);
        value(trade, "--budget", options.budget, "TIME", "Time for all measurements, such as 90s, 10m or 1h (default: 5m)", parseDuration);
        trade->add_option_function<std::vector<std::string>>(
                 "--for", [this](const std::vector<std::string>& texts) {
                     for (const std::string& text : texts) options.wishes.push_back(parseWish("--for", text));
                 },
                 "A wish to recommend a command for: a time (30s) or an error (2%); may be repeated (default: 1s, 10s, 60s, 10%, 5%, 2%)")
            ->type_name("WISH")
            ->type_size(1)
            ->allow_extra_args(false);
        trade->add_flag("--compiler-flags", options.compilerFlags,
                        "Also try flags of the OpenCL compiler that are not strict, in all kernels and in each alone; takes long");
        addDevice(trade, options);
        addLogging(trade, options);

        auto* cache = add("cache", Command::cache, "Print, warm or clear the cache of compiled kernels");
        cache->add_flag("--clear", options.clearCache, "Remove all compiled kernels");
        cache->add_flag("--warm", options.warmCache,
                        "Compile and keep the kernels of these scenes (default: of the scenes that come with the program); after --clear "
                        "if both are given");
        cache->add_option("SCENE", options.scenes, "Scenes for --warm")->type_name("");
        addDevice(cache, options);
        addLogging(cache, options);

        add("list-devices", Command::listDevices, "Print the OpenCL devices");

        /* Internal command: see render/kernel_workers.h */
        auto* compile = add("compile-kernels", Command::compileKernels, "Compile a part of the kernels")->group("");
        compile->add_option("FEATURES", options.compile.features);
        compile->add_option("CONSTANTS", options.compile.constants);
        compile->add_option("PART", options.compile.part);
        compile->add_option("PARTS", options.compile.parts)->check(CLI::PositiveNumber);
        compile->add_option("PARENT", options.compile.parent);
        addDevice(compile, options);

        auto* compare = add("compare", Command::compare, "Print the difference of two images");
        compare->add_option("IMAGE", options.image, "An image file")->type_name("");
        compare->add_option("REFERENCE", options.reference, "The image to compare with")->type_name("");
        compare->add_flag("--json", options.json, "Print JSON");
        compare->add_flag("--scatter", options.scatter,
                          "Estimate standard errors from the spread of the differences in each block, not from the image's variance");
        compare->add_option("--heat-map", options.heatMap, "Write the FLIP of each pixel as an image: black is equal, light yellow is 1")
            ->type_name("FILE");
        value(compare, "--fail-above", options.failAbove, "X", "Exit with status 1 if the mean FLIP is above X", numberFrom(0, 1));

        auto* denoise = add("denoise", Command::denoise, "Remove noise from an image, with Intel Open Image Denoise");
        denoise->add_option("IMAGE", options.image, "An image file; layers albedo and N of an EXR help")->type_name("");
        denoise
            ->add_option("-o,--outfile", options.output.files, "An image file; may be repeated (default: IMAGE-denoised.exr)")
            ->type_name("FILE")
            ->type_size(1)
            ->allow_extra_args(false);
        addToneMapping(denoise, options.output);
        value(denoise, "--nthreads", options.device.threads, "N", "Threads (default: one per core)", integer(1, 4096));

        auto* merge = add("merge", Command::merge, "Make one image of parts that were rendered apart");
        merge->add_option("PART", options.parts, "Film files of render: --samples, --tile, -o PART.film")->type_name("");
        addImageFiles(merge, options.output);
        merge->add_flag("--partial", options.isPartial, "Samples and pixels may be missing");
        addLogging(merge, options);

        auto* submit = add("submit", Command::submit, "Hand an image over to a render farm, in parts");
        addFarm(submit, options.submit);
        addScene(submit, options);
        addImageFiles(submit, options.output);
        addAov(submit, options.output)->group(partsGroup);
        addCheckpointInterval(submit, options.output);
        addDevice(submit, options);
        addLogging(submit, options);

        auto* completion = add("completion", Command::print, "Print a script that completes command lines");
        offer(completion->add_option("SHELL", shell, "bash, zsh or fish")->type_name(""),
              {std::begin(completionShells), std::end(completionShells)});
        add("man", Command::print, "Print the manual page");
    }
};

constexpr const char* getHelp = "Run `eikonal --help` for the commands, `eikonal COMMAND --help` for their options.";

std::vector<std::string> optionsOf(const CLI::App* app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app->get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

/// The words that `offer` keeps.
std::vector<std::string> offered(CLI::Option* option) {
    try {
        std::istringstream words(option->get_validator()->get_name());
        return {std::istream_iterator<std::string>(words), {}};
    } catch (const CLI::OptionNotFound&) { return {}; }
}

OptionDescription described(CLI::Option* option) {
    OptionDescription d;
    for (const std::string& name : option->get_snames()) d.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) d.names.push_back("--" + name);
    if (option->get_positional()) d.names = {option->get_name(true) + (option->get_items_expected_max() > 1 ? " ..." : "")};
    d.help = option->get_description();
    d.group = option->get_group();
    if (option->get_items_expected_max() == 0) return d;
    d.type = option->get_type_name();
    d.words = offered(option);
    const bool isFile = (option->get_positional() || d.type.starts_with("FILE") || d.type == "IMAGE") && d.words.empty();
    d.value = isFile ? ValueHint::file : d.type == "DIR" ? ValueHint::folder : ValueHint::text;
    return d;
}

/// A command with its options in the order of their groups, as --help prints them.
CommandDescription described(CLI::App* app, const std::string& name) {
    CommandDescription command{name, app->get_description(), {}, {}};
    for (const std::string& group : app->get_groups())
        for (CLI::Option* option : app->get_options())
            if (option->get_group() == group) (option->get_positional() ? command.arguments : command.options).push_back(described(option));
    return command;
}

std::vector<CommandDescription> tableOf(Parser& parser) {
    std::vector<CommandDescription> table{described(&parser.app, "")};
    for (const auto& [command, id] : parser.commands)
        if (!command->get_group().empty()) table.push_back(described(command, command->get_name()));
    return table;
}

/// Reports the first argument that a command did not recognise, with a hint.
[[noreturn]] void refuseExtra(const Parser& parser, const CLI::App* command, const std::string& argument) {
    if (argument.size() > 1 && argument[0] == '-') {
        const std::string name = argument.substr(0, argument.find('='));
        const std::string instead = insteadOf(name), near = instead.empty() ? nearestWord(name, optionsOf(command)) : "";
        std::string hint = !instead.empty() ? "; " + instead : near.empty() ? "" : fmt::format("; did you mean {}?", near);
        if (hint.empty())
            for (const auto& [other, id] : parser.commands)
                for (const std::string& option : optionsOf(other))
                    if (option == name && hint.empty()) hint = fmt::format("; {} has it", other->get_name());
        throw UsageError(
            fmt::format("{} has no option {}{}\n{}", command == &parser.app ? "eikonal" : command->get_name(), name, hint, getHelp));
    }
    if (command != &parser.app)
        throw UsageError(fmt::format("{} takes no further argument, but found \"{}\"\n{}", command->get_name(), argument, getHelp));
    std::vector<std::string> names;
    for (const auto& [other, id] : parser.commands)
        if (!other->get_group().empty()) names.push_back(other->get_name());
    const std::string near = nearestWord(argument, names);
    const bool isScene = argument.find(".pbrt") != std::string::npos || argument.find(".obj") != std::string::npos;
    throw UsageError(fmt::format("\"{}\" is not a command; {}\n{}", argument,
                                 isScene ? fmt::format("did you mean `eikonal render {}`?", argument)
                                 : near.empty() ? fmt::format("the commands are {}", fmt::join(names, ", "))
                                                : fmt::format("did you mean {}?", near), getHelp));
}

/// The extension of film files.
constexpr const char* filmExtension = ".film";

/// Among the files of -o, one may be a film, which is then the checkpoint. A part of an image makes no image unless one is named.
void chooseFilm(Options& o) {
    OutputOptions& out = o.output;
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
void checkParts(const Options& o) {
    const OutputOptions& out = o.output;
    if (o.command == Command::merge && o.parts.empty()) throw UsageError("merge needs parts: eikonal merge a.film b.film -o image.exr");
    if (o.command == Command::merge && !out.hasImage && out.checkpoint.empty())
        throw UsageError("merge needs a file to write: -o image.exr, or -o all.film for a larger part");
    if (!out.samples && !out.tile) return;
    if (out.checkpoint.empty()) throw UsageError("--samples and --tile render a part, which merge joins to others; keep it: -o part.film");
    if (out.targetError)
        throw UsageError("--max-error decides by the whole image and all samples, so it goes with neither --samples nor --tile");
}

/// Checks that concern several options.
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
    if (o.output.resume && o.output.checkpoint.empty())
        throw UsageError("--resume goes on from a checkpoint; name it: --checkpoint FILE --resume");
    if (o.scene.cropWindow && o.scene.pixelBounds)
        throw UsageError("--cropwindow and --pixelbounds both select a part of the image; give one of them");
    if (o.scene.camera && o.scene.lookAt && *o.scene.camera == *o.scene.lookAt) throw UsageError("--camera and --look-at must differ");
    if (o.scene.up && *o.scene.up == glm::dvec3(0)) throw UsageError("--up must not be 0,0,0");
}

/// `arguments` with the options of the preset that the user has not given.
std::vector<std::string> withPreset(std::vector<std::string> arguments, const Preset& preset, const CLI::App* command) {
    std::istringstream words(preset.options);
    for (std::string word; words >> word;)
        if (command->get_option(word.substr(0, word.find('=')))->count() == 0) arguments.push_back(word);
    return arguments;
}

/// The options of these groups that the user gave, without -o, as another command takes them.
std::vector<std::string> optionsOfGroups(const CLI::App* command, const std::vector<std::string>& groups) {
    std::vector<std::string> words;
    for (const CLI::Option* option : command->get_options()) {
        const std::string name = option->get_name();   // a long name: --name
        if (option->count() == 0 || option->get_positional() || !std::ranges::count(groups, option->get_group()) || name == "--outfile")
            continue;
        const bool isFlag = option->get_items_expected_max() == 0;
        for (const std::string& value : option->results()) words.push_back(isFlag ? name : name + "=" + value);
    }
    return words;
}

std::vector<Wish> usualWishes() {
    using enum Wish::Kind;
    return {{seconds, 1}, {seconds, 10}, {seconds, 60}, {error, 0.1}, {error, 0.05}, {error, 0.02}};
}

/// What the user gave, without the program's name, in the spelling of the command: `help render` is `render --help`.
std::vector<std::string> inOurSpelling(const Parser& parser, std::vector<std::string> words) {
    const bool wantsHelp = !words.empty() && words[0] == "help";
    if (wantsHelp) words.erase(words.begin());
    const CLI::App* command = &parser.app;
    for (const auto& [sub, id] : parser.commands)
        if (!words.empty() && sub->get_name() == words[0]) command = sub;
    const bool isKnown = words.empty() || command != &parser.app;
    if (wantsHelp && isKnown) words = {"--help"};
    if (wantsHelp && command != &parser.app) words.insert(words.begin(), command->get_name());
    return withOurSpelling(std::move(words), optionsOf(command));
}

}  // namespace

Options parseOptions(const std::vector<std::string>& arguments) {
    Parser parser;
    Options& options = parser.options;
    std::vector<std::string> words(arguments.empty() ? arguments.begin() : std::next(arguments.begin()), arguments.end());
    words = inOurSpelling(parser, std::move(words));
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    for (const std::string& a : arguments) options.commandLine += (options.commandLine.empty() ? "" : " ") + a;
    try {
        parser.app.parse(reversed);
    } catch (const CLI::CallForHelp&) {
        const auto chosen = parser.app.get_subcommands();
        options.text = chosen.empty() ? parser.app.help() : chosen.front()->help("eikonal");
        return options;
    } catch (const CLI::CallForAllHelp&) {
        options.text = parser.app.help("", CLI::AppFormatMode::All);
        return options;
    } catch (const CLI::CallForVersion& version) {
        options.text = std::string(version.what()) + "\n";
        return options;
    } catch (const CLI::ParseError& error) {
        throw UsageError(fmt::format("{}\n{}", error.what(), getHelp));
    }

    const CLI::App* command = &parser.app;
    for (const auto& [sub, id] : parser.commands)
        if (sub->parsed()) { command = sub; options.command = id; }
    if (const auto extra = command->remaining(); !extra.empty()) refuseExtra(parser, command, extra.front());
    if (const auto extra = parser.app.remaining(); !extra.empty()) refuseExtra(parser, &parser.app, extra.front());
    if (options.preset) {
        words.insert(words.begin(), arguments.front());
        const std::vector<std::string> all = withPreset(words, *options.preset, command);
        if (all.size() > words.size()) {
            Options whole = parseOptions(all);
            whole.commandLine = options.commandLine;
            return whole;
        }
    }
    if (options.device.list) options.command = Command::listDevices;
    else if (command == &parser.app)
        throw UsageError(fmt::format("nothing to do; try `eikonal render scene.pbrt -o image.exr`\n{}", getHelp));
    chooseFilm(options);
    checkTogether(parser, command);
    if (command->get_name() == "man") options.text = manualPage(tableOf(parser));
    if (command->get_name() == "completion") options.text = completionScript(parser.shell, tableOf(parser));
    options.passedOn = optionsOfGroups(command, {sceneGroup, objGroup, deviceGroup, partsGroup});
    options.passedToMerge = optionsOfGroups(command, {imageGroup});
    if (options.command == Command::trade && options.wishes.empty()) options.wishes = usualWishes();
    if (options.quiet) options.log = std::min(options.log, LogLevel::error);
    return options;
}

std::vector<CommandDescription> commandLineTable() {
    Parser parser;
    return tableOf(parser);
}

std::vector<std::string> allOptionNames() {
    const Parser parser;
    std::vector<std::string> names = optionsOf(&parser.app);
    for (const auto& [command, id] : parser.commands)
        for (const std::string& name : optionsOf(command)) names.push_back(name);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

}  // namespace eikonal
