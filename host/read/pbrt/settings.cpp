#include "read/pbrt/settings.h"

#include "kinds/camera_kind.h"
#include "kinds/filter_kind.h"
#include "read/pbrt/setting_kinds.h"

#include <fmt/format.h>

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

void Settings::set(Sort sort, const std::string& kindName, const GraphicsState& state, ParameterList parameters,
                   const SourceLocation& where) {
    const Kind& kind = settingKinds()[static_cast<size_t>(sort)]->find(kindName, where);
    if (const auto before = given_.find(sort); before != given_.end())
        reading_.diagnostics.warn(where, fmt::format("{} replaces {}, given at {}", kind.title(), before->second->kind().title(),
                                                     before->second->where().toString()));
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
    if (kind.standIn && sort != Sort::integrator)
        reading_.unsupported(kind.title(), where, kind.title() + " is not rendered yet; " + kind.standIn);
}

/// The value of an option as a parameter with the type of its rule. Throws SceneError.
static Parameter parameterOf(const Kind& option, const std::string& value, const SourceLocation& where, const SourceLocation& valueWhere) {
    const Rule& rule = option.rules.front();
    Parameter parameter;
    parameter.name = rule.name;
    parameter.where = where;
    parameter.whereText = valueWhere;
    const auto expect = [&](bool holds, const char* what) {
        if (!holds) throw SceneError(valueWhere, "\"" + value + "\" found where " + option.title() + " has " + what);
    };
    const auto numbers = [&](auto number, ParameterType type, const char* what) {
        const char* const end = value.data() + value.size();
        const auto [stop, error] = std::from_chars(value.data() + value.starts_with('+'), end, number);
        expect(error == std::errc() && stop == end && std::isfinite(static_cast<double>(number)), what);
        parameter.type = type;
        parameter.values = std::vector{number};
    };
    if (rule.wanted == Wanted::flag) {
        expect(value == "true" || value == "false", "true or false");
        parameter.type = ParameterType::boolean;
        parameter.values = std::vector{value == "true"};
    } else if (rule.wanted == Wanted::integer) numbers(int{}, ParameterType::integer, "an integer");
    else if (rule.wanted == Wanted::number) numbers(double{}, ParameterType::number, "a number");
    else {
        parameter.type = ParameterType::text;
        parameter.values = std::vector{value};
    }
    return parameter;
}

void Settings::setOption(const std::string& name, const std::string& value, bool inWorld, const SourceLocation& where,
                         const SourceLocation& valueWhere) {
    const Kind& option = optionKinds().find(plain(name), where);
    const Arguments arguments(reading_, option, where, {parameterOf(option, value, where, valueWhere)}, nullptr, ColorSpace::srgb);
    FilmDescription& film = reading_.scene.film;
    if (option.name == "seed") seed_ = arguments.integer("seed");
    else if (option.name == "disablepixeljitter")
        withoutJitter_ = arguments.flag("disablepixeljitter") ? std::optional(where) : std::nullopt;
    else if (option.name == "forcediffuse") reading_.scene.forcesDiffuse = arguments.flag("forcediffuse");
    else if (option.name == "displacementedgescale") reading_.displacementEdgeScale = arguments.number("displacementedgescale");
    else if (option.name == "msereferenceimage") {
        errorReference_ = where;
        film.errorReference = arguments.file("msereferenceimage").value_or("");
    } else if (option.name == "msereferenceout") {
        errorLog_ = where;
        film.errorLog = arguments.text("msereferenceout");
    }
    if (inWorld && (option.name == "seed" || option.name == "disablepixeljitter"))
        reading_.unsupported("late " + option.name, where, option.title() + " is ignored after WorldBegin; write it before");
}

void Settings::apply() {
    using Step = void (Settings::*)(const Arguments&);
    constexpr std::pair<Sort, Step> steps[] = {{Sort::camera, &Settings::applyCamera}, {Sort::film, &Settings::applyFilm},
                                               {Sort::filter, &Settings::applyFilter}, {Sort::sampler, &Settings::applySampler},
                                               {Sort::integrator, &Settings::applyIntegrator}};
    reading_.scene.sampler.seed = seed_;
    for (const auto& [sort, step] : steps)
        if (given_.contains(sort))
            reading_.problems.guard([&] {
                (this->*step)(*given_[sort]);
                if (!given_[sort]->kind().standIn) given_[sort]->reportUnused();
            });
    FilmDescription& film = reading_.scene.film;
    film.exposureTime = reading_.scene.camera.shutterClose - reading_.scene.camera.shutterOpen;
    if (withoutJitter_) removeJitter();
}

void Settings::removeJitter() {
    CameraDescription& camera = reading_.scene.camera;
    reading_.scene.filter = {.kind = &box_filter, .xRadius = 0, .yRadius = 0, .where = *withoutJitter_};
    camera.lensRadius = 0;
    camera.shutterOpen = camera.shutterClose = (camera.shutterOpen + camera.shutterClose) / 2;
    if (kindOf(camera).traits.hasLensSystem)
        reading_.unsupported("jitter of a lens", *withoutJitter_,
                             fmt::format(
                                 "option \"disablepixeljitter\": camera \"{}\" samples its lens all the same", kindOf(camera).name));
}

void Settings::finish(MediumRegistry& media) {
    reading_.scene.camera.medium = media.resolve(cameraMedium_, reading_.scene.camera.where);
    if (errorReference_.has_value() != errorLog_.has_value())
        reading_.problems.add(errorLog_ ? *errorLog_ : *errorReference_,
                              errorLog_ ? "option \"msereferenceout\" needs an \"msereferenceimage\" to compare with"
                                        : "option \"msereferenceimage\" needs a file for the errors, \"msereferenceout\"");
}

}  // namespace eikonal::pbrt
