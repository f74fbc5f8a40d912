#include "app/options/shared_options.h"

#include "app/options/declare.h"
#include "kinds/integrator_kind.h"

#include <iterator>

namespace eikonal {

void addLogging(CLI::App* app, Options& o) {
    app->add_flag("--quiet", o.quiet, "Print nothing but errors");
    value(app, "--log-level", o.log, "LEVEL", "What to print: silent, error, warning (default), info, debug",
          oneOf<LogLevel>({{"silent", LogLevel::silent},
                           {"error", LogLevel::error},
                           {"warning", LogLevel::warning},
                           {"info", LogLevel::info},
                           {"debug", LogLevel::debug},
                           {"verbose", LogLevel::debug},  // pbrt's names for the ends
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
                    "The OpenCL device: its number in list-devices, or part of its name (default: a GPU if there is one). Several with "
                    "commas, or \"all\", render an image together")
        ->type_name("NAME|INDEX|all")
        ->group(group);
    value(app, "--nthreads", d.threads, "N", "Threads for loading the scene and, on PoCL, for rendering (default: one per core)",
          integer(1, 4096))
        ->group(group);
    app->add_flag_callback(
           "--no-cache", [&d] { d.cache = false; }, "Compile all kernels, and do not cache them")
        ->group(group);
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
           "--math-flags",
           [&d](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) d.mathFlags.push_back(parseStageFlags("--math-flags", text));
           },
           fmt::format("Flags for the arithmetic of a stage (default: all stages) instead of {}; may be repeated", shippedMathFlags))
        ->type_name("[STAGE:]FLAGS")
        ->type_size(1)
        ->allow_extra_args(false)
        ->group(group);
    app->add_option("--build-options", d.buildOptions,
                    "Additional options for the OpenCL compiler, such as --build-options=-cl-fast-relaxed-math")
        ->type_name(freeText)
        ->group(group);
}

static const std::vector<std::pair<const char*, const IntegratorKind*>>& integratorNames() {
    static const auto names = [] {
        std::vector<std::pair<const char*, const IntegratorKind*>> all;
        for (const IntegratorKind* kind : integratorKindList()) all.emplace_back(kind->name, kind);
        all.emplace_back(volpathAlias, &volpath_integrator);
        return all;
    }();
    return names;
}

/// "a, b, c".
static std::string listOf(const std::vector<std::pair<const char*, const IntegratorKind*>>& names) {
    std::string list;
    for (const auto& [name, kind] : names) list += (list.empty() ? "" : ", ") + std::string(name);
    return list;
}

void addScene(CLI::App* app, Options& o, bool takesOne) {
    SceneOptions& s = o.scene;
    if (takesOne)
        app->add_option("SCENE", s.path,
                        "A pbrt-v4 scene (.pbrt) or a Wavefront OBJ (.obj), also compressed (.gz); -: a pbrt-v4 scene from standard input")
            ->type_name("");
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
    value(app, "--integrator", s.integrator, "NAME", "Light transport algorithm: " + listOf(integratorNames()),
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
    value(app, "--guiding", s.guiding, "NAME",
          "Whether to sample directions also by what pilot paths have learned of where light comes from: off (default); on; auto: in long "
          "renders, where it is measured to pay",
          oneOf<PathGuiding>({std::begin(pathGuidingNames), std::end(pathGuidingNames)}))
        ->group(group);
    value(app, "--regularize", s.regularize, "on|off",
          "Whether to widen narrow microfacets behind rough reflections (biased; pbrt's regularize)",
          oneOf<bool>({{"on", true}, {"off", false}}))
        ->group(group);
    value(app, "--max-component-value", s.maxComponentValue, "X",
          "Scale samples down to this value (biased; pbrt's maxcomponentvalue); 0: do not", numberFrom(0))
        ->group(group);
    value(app, "--fireflies", s.reweightsFireflies, "NAME",
          "Samples far brighter than all around them: keep (default), or reweight, by how many there are (biased; what is taken is "
          "in the layer fireflies)",
          oneOf<bool>({{"keep", false}, {"reweight", true}}))
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
    value(app, "--missing", s.missingFiles, "WHAT",
          "Files that are missing: error (default) lists them all; magenta: textures become magenta, shapes are left out",
          oneOf<MissingFiles>({{"error", MissingFiles::error}, {"magenta", MissingFiles::magenta}}))
        ->group(group);
    app->add_flag("--strict", s.strict, "What is parsed but not rendered, or replaced by a guess, is an error instead of a warning")
        ->group(group);
    value(app, "--camera", s.camera, "x,y,z", "Position of the camera (default: chosen to show the model)", parseVector)->group(objGroup);
    value(app, "--look-at", s.lookAt, "x,y,z", "A point at the centre of the image", parseVector)->group(objGroup);
    value(app, "--up", s.up, "x,y,z", "Up direction of the image (default: 0,1,0)", parseVector)->group(objGroup);
    value(app, "--fov", s.fov, "DEGREES", "Field of view along the shorter side", number(0, 180))->group(objGroup);
}

}  // namespace eikonal
