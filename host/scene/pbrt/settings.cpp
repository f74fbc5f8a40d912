#include "scene/pbrt/settings.h"

#include "scene/pbrt/lens_file.h"
#include "spectra/sensor.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>

namespace eikonal::pbrt {
namespace {

constexpr const char* screenParameters =
    "float frameaspectratio in (0, inf); floats screenwindow; float lensradius = 0 clamped to [0, inf); float focaldistance = 1e6; float shutteropen = 0; float shutterclose = 1";
constexpr const char* filmParameters =
    "integer xresolution = 1280; integer yresolution = 720; floats cropwindow; integers pixelbounds; string filename; float diagonal = 35 in (0, inf);"
    "string sensor = cie1931; float iso = 100 in (0, inf); float whitebalance = 0 in [0, inf); float maxcomponentvalue = 0 in (0, inf); bool savefp16 = true";
constexpr const char* samplerParameters = "integer seed; string randomization";
constexpr const char* instead = "\"volpath\" renders it";

const KindTable& cameraKinds() {
    static const KindTable table("camera", screenParameters, {
        {"perspective", int(CameraKind::perspective), "float fov = 90 in (0, 180)"},
        {"orthographic", int(CameraKind::orthographic), ""},
        {"realistic", int(CameraKind::realistic), "file lensfile; float aperturediameter = 1 in (0, inf); float focusdistance = 10 in (0, inf); string aperture"},
        {"spherical", int(CameraKind::spherical), "string mapping = equalarea"},
    });
    return table;
}

const KindTable& filmKinds() {
    static const KindTable table("film", filmParameters, {
        {"rgb", 0, ""},
        {"gbuffer", 0, "string coordinatesystem = camera", "\"rgb\" takes its place"},
        {"spectral", 0, "integer nbuckets = 16; float lambdamin = 360; float lambdamax = 830", "\"rgb\" takes its place"},
    });
    return table;
}

const KindTable& filterKinds() {
    static const KindTable table("pixel filter", "", {
        {"box", int(FilterKind::box), "float xradius = 0.5 in (0, inf); float yradius = 0.5 in (0, inf)"},
        {"triangle", int(FilterKind::triangle), "float xradius = 2 in (0, inf); float yradius = 2 in (0, inf)"},
        {"gaussian", int(FilterKind::gaussian), "float xradius = 1.5 in (0, inf); float yradius = 1.5 in (0, inf); float sigma = 0.5 in (0, inf)"},
        {"mitchell", int(FilterKind::mitchell), "float xradius = 2 in (0, inf); float yradius = 2 in (0, inf); float B; float C"},
        {"sinc", int(FilterKind::sinc), "float xradius = 4 in (0, inf); float yradius = 4 in (0, inf); float tau = 3 in (0, inf)"},
    });
    return table;
}

const KindTable& samplerKinds() {
    static const KindTable table("sampler", samplerParameters, {
        {"zsobol", int(SamplerKind::sobol), "integer pixelsamples = 16"},
        {"paddedsobol", int(SamplerKind::sobol), "integer pixelsamples = 16"},
        {"sobol", int(SamplerKind::sobol), "integer pixelsamples = 16"},
        {"halton", int(SamplerKind::sobol), "integer pixelsamples = 16"},
        {"pmj02bn", int(SamplerKind::sobol), "integer pixelsamples = 16"},
        {"stratified", int(SamplerKind::sobol), "integer xsamples = 4; integer ysamples = 4; bool jitter = true"},
        {"independent", int(SamplerKind::independent), "integer pixelsamples = 4"},
    });
    return table;
}

const KindTable& integratorKinds() {
    static const KindTable table("integrator", "integer maxdepth = 5", {
        {"path", int(IntegratorKind::path), "string lightsampler; bool regularize = false"},
        {"volpath", int(IntegratorKind::volpath), "string lightsampler; bool regularize = false"},
        {"simplepath", int(IntegratorKind::simplePath), "bool samplelights = true; bool samplebsdf = true"},
        {"simplevolpath", int(IntegratorKind::volpath), ""},
        {"randomwalk", int(IntegratorKind::randomWalk), ""},
        {"ambientocclusion", int(IntegratorKind::ambientOcclusion), "bool cossample = true; float maxdistance in (0, inf)"},
        {"direct", int(IntegratorKind::direct), ""},
        {"whitted", int(IntegratorKind::whitted), "integer rays = 16; integer bundle = 4; float threshold = 0.004 in [0, 1)"},
        {"lightpath", int(IntegratorKind::volpath), "", instead},
        {"bdpt", int(IntegratorKind::volpath), "bool visualizestrategies = false; bool visualizeweights = false; bool regularize = false", instead},
        {"mlt", int(IntegratorKind::volpath),
         "integer bootstrapsamples = 100000; integer chains = 1000; integer mutationsperpixel = 100; float largestepprobability = 0.3;"
         "float sigma = 0.01; bool regularize = false", instead},
        {"sppm", int(IntegratorKind::volpath), "integer photonsperiteration = -1; float radius = 1; integer seed = 0", instead},
        {"function", int(IntegratorKind::volpath), "string function = step; string filename; bool skipbad = true; string imagefilename", instead},
    });
    return table;
}

const KindTable& acceleratorKinds() {
    static const KindTable table("accelerator", "", {
        {"bvh", 0, "string splitmethod = sah; integer maxnodeprims = 4"},
        {"kdtree", 0, "integer intersectcost = 5; integer traversalcost = 1; float emptybonus = 0.5; integer maxprims = 1; integer maxdepth = -1"},
    });
    return table;
}

/// Throws SceneError unless there are `count` values.
template <class T> void expectCount(const Arguments& arguments, const std::string& name, const std::vector<T>& values, size_t count) {
    if (values.size() != count)
        throw SceneError(arguments.whereOf(name), "\"" + arguments.given(name)->declaration() + "\" has " + std::to_string(values.size()) +
                                                      " values; " + std::to_string(count) + " are expected");
}

/// An option's name as pbrt-v4 compares it: without capitals, dashes and underscores.
std::string plain(const std::string& name) {
    std::string result;
    for (const char c : name)
        if (c != '-' && c != '_') result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

}  // namespace

std::vector<const KindTable*> settingKinds() {
    return {&cameraKinds(), &filmKinds(), &filterKinds(), &samplerKinds(), &integratorKinds(), &acceleratorKinds()};
}

void Settings::set(Sort sort, const std::string& kindName, const GraphicsState& state, ParameterList parameters, const SourceLocation& where) {
    const Kind& kind = settingKinds()[static_cast<size_t>(sort)]->find(kindName, where);
    given_[sort] = std::make_unique<Arguments>(reading_, kind, where, std::move(parameters), nullptr, state.space);
    if (sort == Sort::camera) {
        if (!isInvertible(state.transform)) throw SceneError(where, "the camera's transform cannot be inverted; is there a Scale of 0?");
        reading_.scene.camera.worldFromCamera = glm::inverse(state.transform[0]);
        reading_.scene.camera.worldFromCameraAtEnd.reset();
        if (state.moves()) {
            if (!(std::abs(glm::determinant(state.transform[1])) > 0))
                throw SceneError(where, "the camera's transform at the end of its motion cannot be inverted; is there a Scale of 0?");
            reading_.scene.camera.worldFromCameraAtEnd = glm::inverse(state.transform[1]);
        }
        cameraMedium_ = state.outside;
    }
    if (sort == Sort::film) reading_.scene.film.colorSpace = state.space;
    /* For integrators this is said when the scene is packed: --integrator may choose another */
    if (kind.standIn && sort != Sort::integrator) reading_.unsupported(kind.title(), where, kind.title() + " is not rendered yet; " + kind.standIn);
}

void Settings::setOption(const std::string& name, const std::string& value, const SourceLocation& where, const SourceLocation& valueWhere) {
    // Those that change no pixel are only known; those that would are not rendered yet.
    const std::vector<std::string> harmless = {"disablewavelengthjitter", "disabletexturefiltering", "msereferenceimage", "msereferenceout",
                                               "pixelstats", "rendercoordsys", "wavefront", "displacementedgescale"};
    const std::vector<std::string> missing = {"disablepixeljitter", "forcediffuse"};
    const std::string option = plain(name);
    if (option == "seed") {
        const auto [stop, error] = std::from_chars(value.data(), value.data() + value.size(), seed_);
        if (error != std::errc() || stop != value.data() + value.size()) throw SceneError(valueWhere, "\"" + value + "\" found where an integer is expected");
    } else if (std::ranges::count(missing, option)) {
        if (value != "false") reading_.unsupported("option " + option, where, "option \"" + name + "\" has no effect yet");
    } else if (!std::ranges::count(harmless, option)) {
        std::vector<std::string> all = {"seed"};
        all.insert(all.end(), harmless.begin(), harmless.end());
        all.insert(all.end(), missing.begin(), missing.end());
        const std::string near = nearestWord(option, all);
        throw SceneError(where, "there is no option \"" + name + "\"" + (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
    }
}

void Settings::apply() {
    using Step = void (Settings::*)(const Arguments&);
    constexpr std::pair<Sort, Step> steps[] = {{Sort::camera, &Settings::applyCamera}, {Sort::film, &Settings::applyFilm},
                                               {Sort::filter, &Settings::applyFilter}, {Sort::sampler, &Settings::applySampler},
                                               {Sort::integrator, &Settings::applyIntegrator}};
    reading_.scene.sampler.seed = seed_;
    for (const auto& [sort, step] : steps)
        if (given_.contains(sort)) reading_.problems.guard([&] { (this->*step)(*given_[sort]); });
    FilmDescription& film = reading_.scene.film;
    film.exposureTime = reading_.scene.camera.shutterClose - reading_.scene.camera.shutterOpen;
}

void Settings::finish(MediumBook& media) { reading_.scene.camera.medium = media.resolve(cameraMedium_, reading_.scene.camera.where); }

void Settings::applyCamera(const Arguments& arguments) {
    CameraDescription& camera = reading_.scene.camera;
    camera.where = arguments.where();
    camera.kind = static_cast<CameraKind>(arguments.kind().value);
    if (camera.kind == CameraKind::perspective) camera.fov = arguments.number("fov");
    if (arguments.has("frameaspectratio")) camera.frameAspectRatio = arguments.number("frameaspectratio");
    if (arguments.has("screenwindow")) {
        const std::vector<double> window = arguments.numbers("screenwindow");
        expectCount(arguments, "screenwindow", window, 4);
        if (window[0] == window[1] || window[2] == window[3])
            throw SceneError(arguments.whereOf("screenwindow"), "\"float screenwindow\" holds nothing: its values are x0 x1 y0 y1, with x0 other than x1 and y0 other than y1");
        camera.screenWindow = {window[0], window[1], window[2], window[3]};
    }
    if (camera.kind == CameraKind::spherical) applyMapping(arguments);
    if (camera.kind == CameraKind::realistic) applyLens(arguments);
    camera.lensRadius = arguments.number("lensradius");
    camera.focalDistance = arguments.number("focaldistance");
    if (camera.lensRadius > 0 && !(camera.focalDistance > 0))
        throw SceneError(arguments.whereOf("focaldistance"), fmt::format("{}: \"float focaldistance\" is {:g}; with a lens it must be in (0, inf)",
                                                                         arguments.kind().title(), camera.focalDistance));
    camera.shutterOpen = arguments.number("shutteropen");
    camera.shutterClose = arguments.number("shutterclose");
    if (!(camera.shutterClose > camera.shutterOpen))
        throw SceneError(arguments.where(), "the shutter must close after it opens: shutteropen is " + std::to_string(camera.shutterOpen) +
                                                ", shutterclose " + std::to_string(camera.shutterClose));
}

void Settings::applyMapping(const Arguments& arguments) {
    const std::string mapping = arguments.text("mapping");
    if (mapping != "equalarea" && mapping != "equirectangular")
        throw SceneError(arguments.whereOf("mapping"), "there is no mapping \"" + mapping + "\"; it can be \"equalarea\" or \"equirectangular\"");
    reading_.scene.camera.equalArea = mapping == "equalarea";
}

void Settings::applyLens(const Arguments& arguments) {
    CameraDescription& camera = reading_.scene.camera;
    if (!arguments.has("lensfile")) throw SceneError(arguments.where(), "camera \"realistic\" needs a \"string lensfile\"");
    const std::optional<std::string> path = arguments.file("lensfile");
    if (path) camera.lens = readLensFile(*path);
    camera.apertureDiameter = arguments.number("aperturediameter");
    camera.focusDistance = arguments.number("focusdistance");

    const std::string aperture = arguments.text("aperture");
    constexpr std::pair<const char*, ApertureShape> shapes[] = {{"", ApertureShape::round}, {"gaussian", ApertureShape::gaussian},
        {"square", ApertureShape::square}, {"pentagon", ApertureShape::pentagon}, {"star", ApertureShape::star}};
    const auto shape = std::ranges::find(shapes, aperture, [](const auto& s) { return std::string(s.first); });
    if (shape != std::end(shapes)) { camera.aperture = shape->second; return; }
    const std::optional<std::string> image = reading_.findFile(aperture, arguments.whereOf("aperture"));
    if (!image) return;
    camera.aperture = ApertureShape::image;
    camera.apertureImage = static_cast<int>(reading_.scene.images.size());
    ImageFile file;
    file.path = *image;
    file.where = arguments.whereOf("aperture");
    reading_.scene.images.push_back(file);
}

void Settings::applyFilm(const Arguments& arguments) {
    FilmDescription& film = reading_.scene.film;
    film.where = arguments.where();
    film.width = arguments.integer("xresolution");
    film.height = arguments.integer("yresolution");
    if (film.width < 1 || film.height < 1)
        throw SceneError(arguments.where(), "the image is " + std::to_string(film.width) + " x " + std::to_string(film.height) + " pixels; it needs one at least");
    film.filename = arguments.text("filename");
    film.iso = arguments.number("iso");
    film.whiteBalance = arguments.number("whitebalance");
    film.maxComponentValue = arguments.number("maxcomponentvalue");
    film.diagonal = arguments.number("diagonal");
    film.sensor = arguments.text("sensor");
    if (const auto names = sensorNames(); !std::ranges::count(names, film.sensor)) {
        const std::string near = nearestWord(film.sensor, names);
        throw SceneError(arguments.whereOf("sensor"), "there is no sensor \"" + film.sensor + "\"; " +
                                                          (near.empty() ? "cie1931 is the usual one" : "did you mean \"" + near + "\"?"));
    }
    if (arguments.has("pixelbounds")) {
        const std::vector<int> bounds = arguments.integers("pixelbounds");
        expectCount(arguments, "pixelbounds", bounds, 4);
        film.pixelBounds = PixelBounds{std::max(bounds[0], 0), std::min(bounds[1], film.width), std::max(bounds[2], 0), std::min(bounds[3], film.height)};
        if (film.pixelBounds->x0 >= film.pixelBounds->x1 || film.pixelBounds->y0 >= film.pixelBounds->y1)
            throw SceneError(arguments.whereOf("pixelbounds"), "\"integer pixelbounds\" has no pixel of the image; its values are x0 x1 y0 y1");
    }
    if (arguments.has("cropwindow")) {
        const std::vector<double> window = arguments.numbers("cropwindow");
        expectCount(arguments, "cropwindow", window, 4);
        const auto clamp = [](double x) { return std::clamp(x, 0., 1.); };
        film.cropWindow = {clamp(std::min(window[0], window[1])), clamp(std::max(window[0], window[1])), clamp(std::min(window[2], window[3])),
                           clamp(std::max(window[2], window[3]))};
        if (film.pixelBounds)
            reading_.diagnostics.warn(arguments.whereOf("pixelbounds"), "\"pixelbounds\" is ignored, since there is a \"cropwindow\" as well");
        film.pixelBounds.reset();
    }
}

void Settings::applyFilter(const Arguments& arguments) {
    FilterDescription& filter = reading_.scene.filter;
    filter.where = arguments.where();
    filter.kind = static_cast<FilterKind>(arguments.kind().value);
    filter.xRadius = arguments.number("xradius");
    filter.yRadius = arguments.number("yradius");
    if (filter.kind == FilterKind::gaussian) filter.sigma = arguments.number("sigma");
    if (filter.kind == FilterKind::sinc) filter.tau = arguments.number("tau");
    if (filter.kind == FilterKind::mitchell) {
        filter.B = arguments.number("B", 1. / 3);
        filter.C = arguments.number("C", 1. / 3);
    }
}

void Settings::applySampler(const Arguments& arguments) {
    SamplerDescription& sampler = reading_.scene.sampler;
    sampler.where = arguments.where();
    sampler.kind = static_cast<SamplerKind>(arguments.kind().value);
    constexpr long long most = 1 << 30;
    const bool isStratified = arguments.kind().name == "stratified";
    const long long samples = isStratified ? 1ll * arguments.integer("xsamples") * arguments.integer("ysamples") : arguments.integer("pixelsamples");
    if (samples < 1 || samples > most)
        throw SceneError(arguments.where(), "a pixel has " + std::to_string(samples) + " samples; it can have 1 to " + std::to_string(most));
    sampler.pixelSamples = static_cast<int>(samples);
    if (arguments.has("seed")) sampler.seed = arguments.integer("seed");
}

void Settings::applyLightSampler(const Arguments& arguments) {
    const std::string name = arguments.text("lightsampler");
    LightSampler& sampler = reading_.scene.integrator.lightSampler;
    std::vector<std::string> words;
    for (const auto& [word, value] : lightSamplerNames) {
        words.emplace_back(word);
        if (name == word) { sampler = value; return; }
    }
    /* pbrt-v4's fourth: what a tree of bounds comes near to, with the same expectation */
    if (name == "exhaustive") { sampler = LightSampler::bvh; return; }
    const std::string near = nearestWord(name, words);
    throw SceneError(arguments.whereOf("lightsampler"), "there is no light sampler \"" + name + "\"; " +
                                                            (near.empty() ? "there are \"bvh\", \"power\" and \"uniform\"" : "did you mean \"" + near + "\"?"));
}

/// Throws SceneError unless it is a power of two from 1 to mostTreeRays, or the number that `orElse` is.
static int treeRays(const Arguments& arguments, const std::string& name, int orElse) {
    const int rays = arguments.integer(name);
    if (rays != orElse && (rays < 1 || rays > mostTreeRays || !std::has_single_bit(static_cast<unsigned>(rays))))
        throw SceneError(arguments.whereOf(name), fmt::format("\"integer {}\" is {}; it must be {}a power of two from 1 to {}", name, rays,
                                                              orElse == 0 ? "0 or " : "", mostTreeRays));
    return rays;
}

void Settings::applyIntegrator(const Arguments& arguments) {
    IntegratorDescription& integrator = reading_.scene.integrator;
    const Kind& kind = arguments.kind();
    integrator.where = arguments.where();
    integrator.kind = static_cast<IntegratorKind>(kind.value);
    if (kind.standIn) integrator.standsFor = kind.name;
    integrator.maxDepth = arguments.integer("maxdepth");
    if (integrator.maxDepth < 0) throw SceneError(arguments.whereOf("maxdepth"), "\"integer maxdepth\" must not be negative");
    if (kind.rule("lightsampler") && arguments.has("lightsampler")) applyLightSampler(arguments);
    if (kind.rule("regularize")) integrator.regularize = arguments.flag("regularize");
    if (integrator.kind == IntegratorKind::simplePath) {
        integrator.sampleLights = arguments.flag("samplelights");
        integrator.sampleBsdf = arguments.flag("samplebsdf");
    }
    if (integrator.kind == IntegratorKind::ambientOcclusion) {
        integrator.cosine = arguments.flag("cossample");
        if (arguments.has("maxdistance")) integrator.maxDistance = arguments.number("maxdistance");
        integrator.colorSpace = arguments.space();
    }
    if (integrator.kind == IntegratorKind::whitted) {
        integrator.rays = treeRays(arguments, "rays", 1);
        integrator.bundle = treeRays(arguments, "bundle", 0);
        integrator.threshold = arguments.number("threshold");
    }
}

}  // namespace eikonal::pbrt
