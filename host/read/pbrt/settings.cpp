#include "read/pbrt/settings.h"

#include "read/pbrt/setting_kinds.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace eikonal::pbrt {

/// An option's name as pbrt-v4 compares it: lower case, without dashes and underscores.
static std::string plain(const std::string& name) {
    std::string result;
    for (const char c : name)
        if (c != '-' && c != '_') result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
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
    /* For integrators, packing reports it, because --integrator may choose another */
    if (kind.standIn && sort != Sort::integrator) reading_.unsupported(kind.title(), where, kind.title() + " is not rendered yet; " + kind.standIn);
}

void Settings::setOption(const std::string& name, const std::string& value, const SourceLocation& where, const SourceLocation& valueWhere) {
    // Options that change no pixel are accepted silently; the others are not rendered.
    const std::vector<std::string> harmless = {"disablewavelengthjitter", "disabletexturefiltering", "msereferenceimage", "msereferenceout",
                                               "pixelstats", "rendercoordsys", "wavefront"};
    const std::vector<std::string> missing = {"disablepixeljitter", "forcediffuse"};
    const std::string option = plain(name);
    const auto read = [&](auto& number) {
        const char* const end = value.data() + value.size();
        const auto [stop, error] = std::from_chars(value.data() + value.starts_with('+'), end, number);
        return error == std::errc() && stop == end;
    };
    if (option == "seed") {
        if (!read(seed_)) throw SceneError(valueWhere, "\"" + value + "\" found where an integer is expected");
    } else if (option == "displacementedgescale") {
        double& scale = reading_.displacementEdgeScale;
        if (!read(scale) || !(scale > 0 && std::isfinite(scale))) throw SceneError(valueWhere, "\"" + value + "\" found where a number above 0 is expected");
    } else if (std::ranges::count(missing, option)) {
        if (value != "false") reading_.unsupported("option " + option, where, "option \"" + name + "\" has no effect yet");
    } else if (!std::ranges::count(harmless, option)) {
        std::vector<std::string> all = {"seed", "displacementedgescale"};
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

void Settings::finish(MediumRegistry& media) { reading_.scene.camera.medium = media.resolve(cameraMedium_, reading_.scene.camera.where); }

}  // namespace eikonal::pbrt
