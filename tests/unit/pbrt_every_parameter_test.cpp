// Every parameter of every kind, from the rows that the reader reads: it changes what is rendered, or a warning names it, or it stands in
// the list of those without an effect (read/pbrt/without_effect.h). And what is wrong with one is answered.

#include "unit/pbrt_kind_scenes.h"
#include "unit/pbrt_reading.h"

#include "kinds/filter_kind.h"
#include "kinds/integrator_kind.h"
#include "pack/pack.h"
#include "read/pbrt/without_effect.h"
#include "render/session.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace eikonal::pbrt {
namespace {

/// What a scene is rendered as, and what is said about it.
struct Rendered {
    std::string fingerprint;
    std::vector<std::string> warnings;
};

std::string featuresOf(const PackedScene& packed) {
    std::string names;
    for (size_t i = 0; i < featureCount(); ++i)
        if (const auto feature = static_cast<Feature>(i); packed.features.has(feature)) names += featureName(feature) + ' ';
    return names;
}

class EveryParameter : public PbrtTest {
protected:
    EveryParameter() { writeFilesOfScenes(folder_.string()); }

    /// Of the tables that the device gets, of the samples, and of what becomes of the image. Throws SceneError.
    Rendered render(const std::string& text) {
        Diagnostics diagnostics(LogLevel::silent);
        Scene scene = readPbrtText(text, "test.pbrt", folder_.string(), diagnostics);
        std::string displaced;  // displacing needs a device
        for (Shape& shape : scene.shapes) {
            if (shape.displacement) displaced += fmt::format("{} {}", shape.displacement->texture, shape.displacement->edgeLength);
            shape.displacement.reset();
        }
        const PackedScene packed = packScene(scene, diagnostics);
        const FilmDescription& film = scene.film;
        const auto crop = film.cropWindow.value_or(std::array<double, 4>{0, 1, 0, 1});
        const PixelBounds bounds = film.pixelBounds.value_or(PixelBounds());
        const SpectrumKept kept = film.spectrum.value_or(SpectrumKept());
        return {fmt::format("{} {} {} samples {} {} {} film {} {} {} {} {} {} {} {} {} {} {}", sceneHash(packed), featuresOf(packed),
                            displaced, scene.sampler.pixelSamples, scene.sampler.seed, static_cast<int>(scene.sampler.kind), film.filename,
                            fmt::join(crop, ","), bounds.x1, bounds.y1, static_cast<int>(film.gbuffer), kept.buckets,
                            kept.last - kept.first, film.iso, film.exposureTime, film.whiteBalance, film.sensor) +
                    fmt::format(" {} {} {} light sampler {}", film.halfFloats, film.errorReference, film.errorLog,
                                static_cast<int>(scene.integrator.lightSampler)),
                diagnostics.warnings()};
    }

    /// The place of the first parameter in a scene of `place`.
    static std::string at(const KindInPlace& place) { return fmt::format("test.pbrt:{}:{}: ", place.line(), place.directive.size() + 2); }
};

/// Calls f(place, rule, name) for every parameter.
template <class F>
void forEach(F&& f) {
    for (const KindInPlace& place : allKinds())
        for (const Rule& rule : place.kind->rules)
            for (const std::string& name : {rule.name, rule.orElse})
                if (!name.empty()) f(place, rule, name);
}

/// How an option's value is given, from a declaration: "float x" 1 becomes 1.
std::string valueOf(const std::string& declaration) { return declaration.substr(declaration.find("\" ") + 2); }

std::string given(const KindInPlace& place, const std::string& declaration) {
    return place.kind->noun == "option" ? valueOf(declaration) : declaration;
}

/// Whether a line of the list is about this value of a parameter.
bool isListed(const WithoutEffect& line, const Kind& kind, const std::string& name, const std::string& value) {
    return kind.noun == line.noun && (!line.kind || kind.name == line.kind) && (!line.parameter || name == line.parameter) &&
           (!line.value || value == line.value || value == fmt::format("\"{}\"", line.value));
}

class OfADirective : public EveryParameter, public testing::WithParamInterface<std::string> {};

TEST_P(OfADirective, changesTheImageOrIsAnswered) {
    std::map<std::string, std::optional<Rendered>> plain;
    const auto tryToRender = [&](const std::string& text, std::string& said) -> std::optional<Rendered> {
        try {
            return render(text);
        } catch (const SceneError& error) {
            said += std::string("\n    ") + error.what();
            return std::nullopt;
        }
    };
    forEach([&](const KindInPlace& place, const Rule& rule, const std::string& name) {
        /* A warning names kinds with a stand-in; of a single choice there is no other value */
        if (place.kind->noun != GetParam() || place.kind->standIn || rule.choices.size() == 1) return;
        const std::vector<std::string> values = otherValues(place, rule, name);
        EXPECT_FALSE(values.empty()) << place.directive << ": no value of " << name << " is known, see pbrt_kind_scenes.cpp";
        const std::string companion = companionOf(place, name);
        const std::string without = place.kind->noun == "option" ? place.before + place.after : place.scene(companion);
        std::string said;
        std::optional<Rendered> before;  // if the parameter is required: with its first value
        bool isAnswered = false;
        for (const std::string& value : values) {
            said += '\n' + value;
            const std::string with = place.scene(given(place, value) + companion);
            /* The reader knows, so the scene need not be packed, which takes long for a system of lenses */
            errorOf(with);
            const std::string unused = fmt::format(" {}\" is ignored: nothing here uses it", name);
            if (std::ranges::any_of(warnings_, [&](const std::string& warning) { return warning.ends_with(unused); })) {
                isAnswered = true;
                break;
            }
            const std::optional<Rendered> after = tryToRender(with, said);
            if (!after) continue;
            if (!plain.contains(without)) plain[without] = tryToRender(without, said);
            if (plain[without]) before = plain[without];
            const bool isNamed = std::ranges::any_of(after->warnings, [&](const std::string& warning) {
                return (!before || !std::ranges::count(before->warnings, warning)) && warning.find(name) != warning.npos;
            });
            const bool differs = before && after->fingerprint != before->fingerprint;
            bool listed = false;
            for (const WithoutEffect& line : withoutEffect()) {
                if (!isListed(line, *place.kind, name, valueOf(value))) continue;
                listed = true;
                EXPECT_EQ(isNamed, line.answer == Answer::warning) << place.directive << ' ' << value;
                EXPECT_FALSE(differs && !line.value) << place.directive << ' ' << value << " has an effect, in spite of the list";
            }
            if (!before) before = after;
            isAnswered |= differs || isNamed || listed;
            if (!rule.choices.empty()) {
                EXPECT_TRUE(differs || isNamed || listed) << place.directive << ' ' << value;
            } else if (isAnswered) break;
        }
        EXPECT_TRUE(isAnswered) << place.directive << ' ' << name << " is ignored in silence:" << said;
    });
}

INSTANTIATE_TEST_SUITE_P(EveryParameter, OfADirective,
                         testing::Values("camera", "film", "pixel filter", "sampler", "integrator", "accelerator", "option", "light",
                                         "area light", "shape", "material", "texture", "medium"),
                         [](const auto& info) {
                             std::string name = info.param;
                             std::erase(name, ' ');
                             return name;
                         });

/// The list of those without an effect has no line about something that no kind has.
TEST_F(EveryParameter, ofTheListExists) {
    for (const WithoutEffect& line : withoutEffect()) {
        bool isThere = false;
        for (const KindInPlace& place : allKinds())
            for (const Rule& rule : place.kind->rules)
                if (place.kind->noun == line.noun && (!line.kind || place.kind->name == line.kind) &&
                    (!line.parameter || rule.name == line.parameter) &&
                    (!line.value || rule.wanted == Wanted::flag || std::ranges::count(rule.choices, line.value)))
                    isThere = true;
        EXPECT_TRUE(isThere) << line.noun << ' ' << (line.kind ? line.kind : "") << ' ' << (line.parameter ? line.parameter : "");
    }
}

using WrongParameter = EveryParameter;

TEST_F(WrongParameter, ofAnotherTypeIsAnError) {
    constexpr ParameterType types[] = {ParameterType::boolean, ParameterType::text, ParameterType::point2, ParameterType::number};
    forEach([&](const KindInPlace& place, const Rule& rule, const std::string& name) {
        if (place.kind->noun == "option") return;
        const auto isWrong = [&](ParameterType type) {
            return std::ranges::none_of(
                place.kind->rules, [&](const Rule& other) { return other.hasName(name) && accepts(other, type); });
        };
        const ParameterType type = *std::ranges::find_if(types, isWrong);
        EXPECT_THAT(errorOf(place.scene(anyValue(type, name))),
                    HasSubstr(fmt::format("{}\"{} {}\" found where {} has {}", at(place), nameOf(type), name, place.kind->title(),
                                          acceptedDeclarations(rule, name))));
    });
}

TEST_F(WrongParameter, outOfRangeIsAnErrorOrClamped) {
    int count = 0;
    forEach([&](const KindInPlace& place, const Rule& rule, const std::string& name) {
        if (!rule.range) return;
        ++count;
        const Range& range = *rule.range;
        const bool isBelow = std::isfinite(range.low);
        const double end = isBelow ? range.low : range.high, beyond = end + (isBelow ? -1 : 1);
        const bool isOption = place.kind->noun == "option", isInteger = rule.wanted == Wanted::integer;
        const std::string declaration = fmt::format("{} {}", isInteger ? "integer" : "float", name);
        const std::string value = isOption ? fmt::format("{:g}", beyond) : fmt::format("\"{}\" {:g}", declaration, beyond);
        const std::string found = fmt::format("{}: \"{}\" is {:g}; ", place.kind->title(), declaration, beyond);
        const std::string message =
            range.clamps ? fmt::format("{}warning: {}it counts as {:g}, since it must be in {}", at(place), found, end, range.text)
                         : fmt::format("{}{}it must be in {}", isOption ? fmt::format("test.pbrt:{}:8: ", place.line()) : at(place), found,
                                       range.text);
        errorOf(place.scene(value));
        const std::vector<std::string> warnings = warnings_;
        const std::string error = errorOf(place.scene(value));
        if (range.clamps) {
            EXPECT_THAT(warnings, testing::Contains(message)) << error;
        } else EXPECT_THAT(error, HasSubstr(message));
    });
    EXPECT_GT(count, 50);
}

TEST_F(WrongParameter, thatIsNoneOfTheChoicesIsAnError) {
    int count = 0;
    forEach([&](const KindInPlace& place, const Rule& rule, const std::string& name) {
        if (rule.choices.empty()) return;
        ++count;
        const bool isOption = place.kind->noun == "option";
        const std::string value = isOption ? "\"banana\"" : fmt::format("\"string {}\" \"banana\"", name);
        const std::string error = errorOf(place.scene(value));  // others may follow from it
        EXPECT_EQ(error.substr(0, error.find('\n')), fmt::format("{}{}: \"string {}\" is \"banana\"; it can be {}",
                                                                 isOption ? fmt::format("test.pbrt:{}:8: ", place.line()) : at(place),
                                                                 place.kind->title(), name, alternatives(rule.choices)));
    });
    EXPECT_GT(count, 10);
}

TEST_F(WrongParameter, ofAnotherNameIsAWarningOrWithStrictAnError) {
    forEach([&](const KindInPlace& place, const Rule&, const std::string& name) {
        if (place.kind->noun == "option") return;
        const std::string misspelt = name + "qq";
        const std::string message = fmt::format("\"bool {}\" is ignored, since {} has no such parameter", misspelt, place.kind->title());
        const std::string near = nearestWord(misspelt, place.kind->parameters());
        const std::string end = fmt::format("{} (it has {})", near.empty() ? "" : fmt::format("; did you mean \"{}\"?", near),
                                            fmt::join(place.kind->parameters(), ", "));
        const std::string text = place.scene(fmt::format("\"bool {}\" true", misspelt));
        errorOf(text);
        EXPECT_THAT(warnings_, testing::Contains(at(place) + "warning: " + message + end));
        EXPECT_THAT(errorOf(text, true), HasSubstr(at(place) + message + end + " (an error because of --strict)"));
    });
}

TEST_F(WrongParameter, ofAnOptionIsAnError) {
    EXPECT_EQ(errorOf("Option \"wavefront\" banana WorldBegin"),
              "test.pbrt:1:20: \"banana\" found where option \"wavefront\" has true or false");
    EXPECT_EQ(errorOf("Option \"seed\" 1.5 WorldBegin"), "test.pbrt:1:15: \"1.5\" found where option \"seed\" has an integer");
    EXPECT_EQ(errorOf("Option \"displacement-edge-scale\" x WorldBegin"),
              "test.pbrt:1:34: \"x\" found where option \"displacementedgescale\" has a number");
    EXPECT_EQ(errorOf("Option \"pixel_stat\" true WorldBegin"),
              "test.pbrt:1:8: there is no option \"pixelstat\"; did you mean \"pixelstats\"?");
    EXPECT_EQ(errorOf("WorldBegin Option \"seed\" 3", true),
              "test.pbrt:1:19: option \"seed\" is ignored after WorldBegin; write it before (an error because of --strict)");
}

}  // namespace
}  // namespace eikonal::pbrt
