#include "app/trade/study.h"

#include "app/trade/followed_light.h"
#include "app/trade/setting_renderer.h"
#include "clock.h"
#include "error.h"
#include "image/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace eikonal {
namespace {

/// The parts of the budget that the first look leaves: references until the first share is spent, every ladder until the second, higher
/// rungs until the third; what is left is for runs at full size.
constexpr double referenceShare = 0.3, ladderShare = 0.75, combinationShare = 0.8, higherShare = 0.85;
constexpr int firstLookSize = 96;  // pixels along the longer side
constexpr double firstLookSamples = 4;
constexpr int leastPixels = 48 * 48;
constexpr int referenceSeeds = 1 << 20;  // the seeds of references begin here
constexpr double mostAdaptiveSamples = 65536;

/// A size of the same shape with about `pixels` pixels, but not more than `full`.
std::array<int, 2> scaledTo(const std::array<int, 2>& full, double pixels) {
    const double scale = std::sqrt(std::min(1., pixels / (static_cast<double>(full[0]) * full[1])));
    if (scale > 0.8) return full;
    return {std::max(1, static_cast<int>(std::lround(full[0] * scale))), std::max(1, static_cast<int>(std::lround(full[1] * scale)))};
}

/// The mean of two images that stand for different numbers of samples.
FilmImage weighted(const FilmImage& a, double samplesOfA, const FilmImage& b, double samplesOfB) {
    FilmImage image = a;
    for (size_t i = 0; i < image.color.size(); ++i)
        image.color[i] = glm::vec3((glm::dvec3(a.color[i]) * samplesOfA + glm::dvec3(b.color[i]) * samplesOfB) / (samplesOfA + samplesOfB));
    return image;
}

void checkBrightness(double mean, const std::string& scene) {
    if (!(mean > 0) || !std::isfinite(mean))
        throw Error(ExitCode::scene, fmt::format("the image of \"{}\" is black, so relative errors are undefined", scene));
}

}  // namespace

Study::Study(Request request) : request_(std::move(request)) {
    const Stopwatch time;
    clock_ = [time] { return time.seconds(); };
    report("reading the scene");
    lookAtScene();
    if (!hasLooked()) return;
    std::error_code failure;
    std::filesystem::create_directories(request_.folder + "/points", failure);
    if (failure) throw Error(ExitCode::scene, fmt::format("cannot create the folder \"{}\": {}", request_.folder, failure.message()));
    save();
}

double Study::share(double part) const { return state_.lookSeconds + part * (request_.budgetSeconds - state_.lookSeconds); }

double Study::spent() const { return spentBefore_ + clock_(); }

void Study::report(const std::string& what) const {
    const double left = std::max(0., request_.budgetSeconds - spent());
    if (request_.progress) request_.progress({std::min(1., spent() / request_.budgetSeconds), left, what});
}

void Study::save() {
    state_.spentSeconds = spent();
    state_.save(stateFile());
}

std::string Study::stemOf(const Point& point) const {
    return fmt::format("{}/points/{}-{:g}-{}", request_.folder, point.setting, point.rung, point.seeds.size());
}

std::string Study::stemOfReference(size_t which) const {
    return fmt::format("{}/reference-{}-{:.0f}.exr", request_.folder, which + 1, state_.referenceSamples);
}

std::vector<std::string> Study::optionsOf(const Setting& setting, double rung, std::optional<std::array<int, 2>> size) const {
    std::vector<std::string> more = setting.options;
    if (setting.ladder == Ladder::targetErrors) {
        more.push_back(fmt::format("--target-error={:.3g}", rung));
        more.push_back(studyMetricOption());
        /* Measured ones end where they would take far more than other points do */
        more.push_back(fmt::format("--spp={:.0f}", size ? 16 * rungs[std::size(rungs) - 1] : mostAdaptiveSamples));
    } else more.push_back(fmt::format("--spp={:.0f}", rung));
    if (size && *size != state_.full) more.push_back(fmt::format("--resolution={}x{}", (*size)[0], (*size)[1]));
    return overridden(request_.options, more);
}

void Study::lookAtScene() {
    StudyState expected;
    expected.scene = request_.scene;
    expected.version = EIKONAL_VERSION;
    expected.baseOptions = request_.options;
    {
        /* The size of the user's image, and what identifies the scene */
        Options options = renderOptions(request_.scene, request_.options);
        options.log = request_.log;
        Diagnostics diagnostics(options.log, options.scene.strict);
        Session session(options, diagnostics);
        session.load();
        session.pack({});
        const settings& frame = session.packed().frame();
        expected.full = {static_cast<int>(frame.width), static_cast<int>(frame.height)};
        expected.sceneHash = sceneHash(session.packed());
        expected.device = session.context().device().name;
        const PixelRect& part = session.packed().pixels;
        if (part.width() != expected.full[0] || part.height() != expected.full[1])
            throw UsageError("trade measures whole images: give no crop, and --cropwindow 0,1,0,1 if the scene has one");
    }
    if (std::optional<StudyState> earlier = StudyState::load(stateFile(), expected)) {
        state_ = std::move(*earlier);
        spentBefore_ = state_.spentSeconds;
        if (request_.withCompilerFlags && std::ranges::none_of(state_.settings, &Setting::compiles))
            throw UsageError(
                fmt::format("the study in \"{}\" was begun without --compiler-flags; remove it or choose another -o", request_.folder));
        return;
    }
    state_ = expected;
    /* The first session compiles, the second shows how long a scene takes to load */
    const Setting given{"as given", "", {}, false, false, Ladder::samples, false};
    const double longer = std::max(state_.full[0], state_.full[1]), scale = std::min(1., firstLookSize / longer);
    const std::array<int, 2> small = scaledTo(state_.full, pixelsOf(state_.full) * scale * scale);
    const std::vector<std::string> options = optionsOf(given, firstLookSamples, small);
    report("compiling kernels");
    { SettingRenderer first(request_.scene, options); }
    report("a first look");
    SettingRenderer second(request_.scene, options);
    state_.prepareSeconds = second.prepareSeconds();
    const TimedImage look = second.render(referenceSeeds - 1, request_.stop);
    if (isInterrupted()) return;
    state_.brightness = meanOf(look.image);
    checkBrightness(state_.brightness, request_.scene);
    state_.pathSeconds = look.renderSeconds / (look.meanSamples * static_cast<double>(look.image.pixelCount()));
    const IntegratorKind* const follower = followerOf(second.session(), request_.scene, options);
    state_.settings = settingsFor(second.session(), state_.brightness, request_.withCompilerFlags, follower);
    state_.reference = referenceOptions(second.session(), follower);
    state_.lookSeconds = spent();
    chooseSize();
}

void Study::chooseSize() {
    /* Each setting is rendered with all seeds at all rungs, each rung in two sessions; but about half of the settings prove to be without
       effect, hopeless or done before the last rung */
    constexpr double usualShare = 0.6;
    double samples = 0, usual = 0;
    for (double rung : rungs) samples += seeds * rung * usualShare;
    for (const Setting& s : state_.settings) usual += s.compiles ? 0 : 1;
    const double sessions = usual * static_cast<double>(std::size(rungs)) * 2 * state_.prepareSeconds;
    const double seconds = std::max(share(ladderShare) - share(referenceShare) - sessions, 0.1 * (request_.budgetSeconds - spent()));
    state_.studied = scaledTo(state_.full, std::max<double>(leastPixels, seconds / (usual * samples * state_.pathSeconds)));
}

double Study::costOf(double samples) const { return samples * pixelsOf(state_.studied) * state_.pathSeconds; }

/// What `load` reads from the study's folder. Adds to its errors what the user can do.
template <class F>
static auto fromFolder(const std::string& folder, F&& load) {
    try {
        return load();
    } catch (const Error& error) {
        throw Error(ExitCode::scene, fmt::format("{}; remove \"{}\" to begin the study anew", error.what(), folder));
    }
}

References Study::loadReferences() const {
    return fromFolder(request_.folder, [&] {
        return References{readImage(stemOfReference(0)).image, readImage(stemOfReference(1)).image};
    });
}

PointImages Study::loadImages(const Point& point) const {
    return fromFolder(request_.folder, [&] { return PointImages::load(stemOf(point), static_cast<int>(point.seeds.size())); });
}

void Study::renderReferences(double until) {
    const double enough = 64 * std::max(state_.ladderTop(), rungs[std::size(rungs) - 1]);  // for points with as many samples
    if (state_.referenceSamples >= enough || (state_.referenceSamples > 0 && isOver(until))) return;
    const Setting setting{"reference", "", state_.reference, false, false, Ladder::samples, false};
    const double seconds = std::max(until - spent(), 1.), most = seconds / 8 / costOf(1);  // several batches, so that time is kept
    const double batch = std::exp2(std::clamp(std::floor(std::log2(most)), 2., 10.));
    report("compiling kernels for the references");
    SettingRenderer renderer(request_.scene, optionsOf(setting, batch, state_.studied));
    do {
        const double before = state_.referenceSamples;
        std::array<FilmImage, 2> images;
        for (size_t which : {0u, 1u}) {
            report(fmt::format("reference {} of 2, {:.0f} samples", which + 1, before));
            const TimedImage render =
                renderer.render(referenceSeeds + 2 * static_cast<int>(before) + static_cast<int>(which), request_.stop);
            if (!render.isFinished) return;
            images[which] = render.image;
            if (before > 0) images[which] = weighted(readImage(stemOfReference(which)).image, before, render.image, batch);
            state_.referenceSeconds += render.renderSeconds;
        }
        /* Files of the old number of samples stay until the state has the new one */
        const std::array<std::string, 2> old{stemOfReference(0), stemOfReference(1)};
        state_.referenceSamples += batch;
        for (size_t which : {0u, 1u}) writeImage(stemOfReference(which), images[which], {});
        save();
        for (const std::string& file : old) std::filesystem::remove(file);
    } while (!isOver(until) && state_.referenceSamples < enough);
}

void Study::confirmAt(size_t setting, double rung) {
    report(fmt::format("{} at full size", state_.settings[setting].name()));
    Confirmation c;
    try {
        std::vector<std::string> options = optionsOf(state_.settings[setting], rung);
        /* Where an error is asked for, the metric would change the image */
        if (!renderOptions(request_.scene, options).output.targetError) options = overridden(options, {studyMetricOption()});
        c = confirm(request_.scene, options, request_.folder);
    } catch (const Error& error) {
        if (isInterrupted()) return;
        c.failure = error.what();
    }
    c.setting = setting;
    c.rung = rung;
    state_.confirmations.push_back(c);
    save();
}

void Study::run() {
    if (!hasLooked()) return;
    if (!isInterrupted()) renderReferences(share(referenceShare));
    if (state_.referenceSamples == 0 || isInterrupted()) return;
    /* Whatever the budget is, the user's own options are measured */
    for (size_t i : {0u, 1u}) climb(0, rungs[i], seedsInASession);
    climbAll(share(ladderShare));
    addCombination();
    climbAll(share(combinationShare));
    climbHigher(share(higherShare));
    save();
}

}  // namespace eikonal
