// Fills in the scene's film, filter and sampler from the parameters of Film, PixelFilter and Sampler directives.

#include "read/pbrt/settings.h"
#include "kinds/filter_kind.h"
#include "color/sensor.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal::pbrt {

static SpectrumKept spectrumOf(const Arguments& arguments) {
    const SpectrumKept kept{arguments.integer("nbuckets"), arguments.number("lambdamin"), arguments.number("lambdamax")};
    constexpr double narrowest = 1;
    if (!(kept.last - kept.first >= narrowest))
        throw SceneError(arguments.whereOf(arguments.has("lambdamax") ? "lambdamax" : "lambdamin"),
                         fmt::format("{}: its wavelengths are from {:g} to {:g} nm; \"float lambdamax\" must be greater than \"float "
                                     "lambdamin\", by {:g} nm at least",
                                     arguments.kind().title(), kept.first, kept.last, narrowest));
    return kept;
}

void Settings::applyFilm(const Arguments& arguments) {
    FilmDescription& film = reading_.scene.film;
    film.where = arguments.where();
    film.width = arguments.integer("xresolution");
    film.height = arguments.integer("yresolution");
    if (film.width < 1 || film.height < 1)
        throw SceneError(arguments.where(), "the image is " + std::to_string(film.width) + " x " + std::to_string(film.height) +
                                                " pixels; it needs at least one");
    film.filename = arguments.text("filename");
    film.iso = arguments.number("iso");
    film.whiteBalance = arguments.number("whitebalance");
    constexpr double coldest = 100;  // a colder black body has no visible light
    if (film.whiteBalance > 0 && film.whiteBalance < coldest)
        throw SceneError(
            arguments.whereOf("whitebalance"),
            fmt::format("film \"{}\": \"float whitebalance\" is {:g}; it is a temperature in kelvin of at least {:g}, or 0 for none",
                        arguments.kind().name, film.whiteBalance, coldest));
    film.maxComponentValue = arguments.number("maxcomponentvalue");
    film.halfFloats = arguments.flag("savefp16");
    film.diagonal = arguments.number("diagonal");
    film.sensor = arguments.text("sensor");
    if (const auto names = sensorNames(); !std::ranges::count(names, film.sensor)) {
        const std::string near = nearestWord(film.sensor, names);
        throw SceneError(arguments.whereOf("sensor"),
                         "there is no sensor \"" + film.sensor + "\"; " +
                             (near.empty() ? fmt::format("it can be {}", fmt::join(names, ", ")) : "did you mean \"" + near + "\"?"));
    }
    const auto kind = static_cast<FilmKind>(arguments.kind().value);
    if (kind == FilmKind::gbuffer)
        film.gbuffer = arguments.text("coordinatesystem") == "world" ? GBuffer::worldSpace : GBuffer::cameraSpace;
    if (kind == FilmKind::spectral) film.spectrum = spectrumOf(arguments);
    if (arguments.has("pixelbounds")) {
        const std::vector<int> bounds = arguments.integers("pixelbounds");
        expectCount(arguments, "pixelbounds", bounds, 4);
        film.pixelBounds =
            PixelBounds{std::max(bounds[0], 0), std::min(bounds[1], film.width), std::max(bounds[2], 0), std::min(bounds[3], film.height)};
        if (film.pixelBounds->x0 >= film.pixelBounds->x1 || film.pixelBounds->y0 >= film.pixelBounds->y1)
            throw SceneError(arguments.whereOf("pixelbounds"),
                             "\"integer pixelbounds\" has no pixel of the image; its values are x0 x1 y0 y1");
    }
    if (arguments.has("cropwindow")) {
        const std::vector<double> window = arguments.numbers("cropwindow");
        expectCount(arguments, "cropwindow", window, 4);
        const auto clamp = [](double x) { return std::clamp(x, 0., 1.); };
        film.cropWindow = {clamp(std::min(window[0], window[1])), clamp(std::max(window[0], window[1])),
                           clamp(std::min(window[2], window[3])), clamp(std::max(window[2], window[3]))};
        if (film.pixelBounds)
            reading_.diagnostics.warn(arguments.whereOf("pixelbounds"),
                                      "\"pixelbounds\" is ignored, since there is a \"cropwindow\" as well");
        film.pixelBounds.reset();
    }
}

void Settings::applyFilter(const Arguments& arguments) {
    FilterDescription& filter = reading_.scene.filter;
    filter.where = arguments.where();
    filter.kind = filterKindList()[static_cast<size_t>(arguments.kind().value)];
    filter.xRadius = arguments.number("xradius");
    filter.yRadius = arguments.number("yradius");
    if (filter.kind->read) filter.kind->read(arguments, filter);
}

void Settings::applySampler(const Arguments& arguments) {
    SamplerDescription& sampler = reading_.scene.sampler;
    sampler.where = arguments.where();
    sampler.kind = static_cast<SamplerKind>(arguments.kind().value);
    constexpr long long most = 1 << 30;
    const bool isStratified = arguments.kind().name == "stratified";
    const long long samples =
        isStratified ? 1ll * arguments.integer("xsamples") * arguments.integer("ysamples") : arguments.integer("pixelsamples");
    if (samples < 1 || samples > most)
        throw SceneError(arguments.where(),
                         "a pixel has " + std::to_string(samples) + " samples; it can have 1 to " + std::to_string(most));
    sampler.pixelSamples = static_cast<int>(samples);
    if (arguments.has("seed")) sampler.seed = arguments.integer("seed");
}

}  // namespace eikonal::pbrt
