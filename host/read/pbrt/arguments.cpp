#include "read/pbrt/arguments.h"

#include "read/pbrt/version3.h"
#include "read/pbrt/without_effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <ranges>
#include <stdexcept>

namespace eikonal::pbrt {
namespace {

std::string parameterNames(const Kind& kind) {
    std::string names;
    for (const std::string& name : kind.parameters()) names += (names.empty() ? "" : ", ") + name;
    return names.empty() ? "it has none" : "it has " + names;
}

/// Reports a parameter that the kind does not have.
void reject(Reading& reading, const Kind& kind, const Parameter& parameter) {
    const std::string shown = "\"" + parameter.declaration() + "\"";
    for (const Rule& rule : kind.rules)
        if (rule.hasName(parameter.name))
            throw SceneError(parameter.where,
                             shown + " found where " + kind.title() + " has " + acceptedDeclarations(rule, parameter.name));
    if (const auto successor = successorOf("parameter", parameter.name)) throw Version3Error(parameter.where, shown, successor->c_str());
    const std::string near = nearestWord(parameter.name, kind.parameters());
    reading.unsupported("parameter " + kind.title() + " " + parameter.name, parameter.where,
                        shown + " is ignored, since " + kind.title() + " has no such parameter" +
                            (near.empty() ? "" : "; did you mean \"" + near + "\"?") + " (" + parameterNames(kind) + ")");
}

std::string shown(double number) { return fmt::format("{:g}", number); }

/// The rule that limits the parameter's values; null if there is none.
const Rule* limitingRule(const Kind& kind, const Parameter& parameter) {
    const Rule* rule = kind.ruleFor(parameter);
    if (!rule || !(rule->range || !rule->choices.empty())) return nullptr;
    const bool isNumber = parameter.type == ParameterType::number || parameter.type == ParameterType::integer;
    return isNumber || parameter.type == ParameterType::text ? rule : nullptr;
}

void checkChoice(const Rule& rule, const std::string& word, const Kind& kind, const Parameter& parameter) {
    if (std::ranges::count(rule.choices, word)) return;
    const std::string near = nearestWord(word, rule.choices);
    throw SceneError(parameter.where, kind.title() + ": \"" + parameter.declaration() + "\" is \"" + word + "\"; it can be " +
                                          alternatives(rule.choices) + (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
}

/// Reports a parameter that is in the list of those without an effect.
void reportWithoutEffect(Reading& reading, const Kind& kind, const Parameter& parameter) {
    const WithoutEffect* line = withoutEffect(kind, parameter);
    if (!line || line->answer == Answer::silence) return;
    const auto* words = std::get_if<std::vector<std::string>>(&parameter.values);
    const std::string value = line->value && words ? " \"" + words->front() + "\"" : "";
    reading.unsupported(kind.title() + " " + parameter.name, parameter.where,
                        kind.title() + ": \"" + parameter.declaration() + "\"" + value + " has no effect: " + line->why);
}

/// Clamps a number to its range or throws SceneError.
template <class T> void keepTo(const Range& range, T& number, const Kind& kind, const Parameter& parameter, Reading& reading) {
    if (range.holds(number)) return;
    const std::string found = kind.title() + ": \"" + parameter.declaration() + "\" is " + shown(number);
    if (!range.clamps) throw SceneError(parameter.where, found + "; it must be in " + range.text);
    const double end = std::clamp(static_cast<double>(number), range.low, range.high);
    reading.diagnostics.warnOnce("range of " + kind.title() + " " + parameter.name, parameter.where,
                                 found + "; it counts as " + shown(end) + ", since it must be in " + range.text);
    number = static_cast<T>(end);
}

/// Whether a parameter is an empty name of a file, which counts as not given: a warning says so once.
bool isEmptyFile(const Rule& rule, const Parameter& parameter, const Kind& kind, Reading& reading) {
    const auto* words = std::get_if<std::vector<std::string>>(&parameter.values);
    if (rule.wanted != Wanted::file || !words || words->size() != 1 || !words->front().empty()) return false;
    reading.diagnostics.warnOnce("empty " + parameter.where.toString(), parameter.where,
                                 kind.title() + ": \"" + parameter.declaration() + "\" is empty, and counts as not given");
    return true;
}

}  // namespace

Arguments::Arguments(Reading& reading, const Kind& kind, SourceLocation where, ParameterList own,
                     std::shared_ptr<const ParameterList> inherited, ColorSpace space)
    : reading_(&reading), kind_(&kind), where_(std::move(where)), own_(std::move(own)), inherited_(std::move(inherited)), space_(space) {
    for (const Parameter& parameter : own_)
        if (!kind.ruleFor(parameter)) reject(reading, kind, parameter);
    checkValues();
    for (const Parameter& parameter : own_) reportWithoutEffect(reading, kind, parameter);
}

void Arguments::checkValues() {
    const auto keep = [this](Parameter& parameter) {
        const Rule* rule = limitingRule(*kind_, parameter);
        if (!rule) return;
        if (const auto* words = std::get_if<std::vector<std::string>>(&parameter.values))
            for (const std::string& word : *words) checkChoice(*rule, word, *kind_, parameter);
        if (auto* numbers = std::get_if<std::vector<double>>(&parameter.values))
            for (double& number : *numbers) keepTo(*rule->range, number, *kind_, parameter, *reading_);
        if (auto* integers = std::get_if<std::vector<int>>(&parameter.values))
            for (int& integer : *integers) keepTo(*rule->range, integer, *kind_, parameter, *reading_);
    };
    for (Parameter& parameter : own_) keep(parameter);
    if (!inherited_ || std::ranges::none_of(*inherited_, [this](const Parameter& parameter) { return limitingRule(*kind_, parameter); }))
        return;
    ParameterList kept = *inherited_;
    for (Parameter& parameter : kept) keep(parameter);
    inherited_ = std::make_shared<const ParameterList>(std::move(kept));
}

const Rule& Arguments::rule(const std::string& name) const {
    const Rule* rule = kind_->rule(name);
    if (!rule) throw std::logic_error(kind_->title() + " has no rule for \"" + name + "\"");
    return *rule;
}

const Parameter* Arguments::given(const std::string& name) const {
    const Rule& r = rule(name);
    const auto last = [&](const ParameterList& list, const std::string& wanted) -> const Parameter* {
        for (const Parameter& parameter : list | std::views::reverse)
            if (parameter.name == wanted && accepts(r, parameter.type)) return &parameter;
        return nullptr;
    };
    for (const std::string& wanted : {r.name, r.orElse}) {
        if (wanted.empty()) continue;
        const Parameter* found = last(own_, wanted);
        if (found) found->isUsed = true;
        else if (inherited_) found = last(*inherited_, wanted);
        if (found) return isEmptyFile(r, *found, *kind_, *reading_) ? nullptr : found;
    }
    return nullptr;
}

void Arguments::reportUnused() const {
    const auto isLast = [this](const Parameter& parameter) {
        const auto last = std::ranges::find(own_ | std::views::reverse, parameter.name, &Parameter::name);
        return &*last == &parameter;
    };
    for (const Parameter& parameter : own_) {
        const Rule* rule = kind_->ruleFor(parameter);
        if (parameter.isUsed || !rule || withoutEffect(*kind_, parameter) || isDefault(*rule, parameter)) continue;
        const std::string title = kind_->title() + ": \"" + parameter.declaration() + "\"";
        if (!isLast(parameter))
            reading_->diagnostics.warn(parameter.where, title + " is ignored: it is given again, and the last counts");
        else
            reading_->unsupported("unused " + title, parameter.where, title + " is ignored: nothing here uses it");
    }
}

const SourceLocation& Arguments::whereOf(const std::string& name) const {
    const Parameter* parameter = given(name);
    return parameter ? parameter->where : where_;
}

template <class T> const std::vector<T>* Arguments::values(const std::string& name) const {
    const Parameter* parameter = given(name);
    return parameter ? &std::get<std::vector<T>>(parameter->values) : nullptr;
}

template <class T> std::optional<T> Arguments::single(const std::string& name) const {
    const std::vector<T>* all = values<T>(name);
    if (!all) return std::nullopt;
    if (all->size() != 1)
        throw SceneError(whereOf(name),
                         "\"" + given(name)->declaration() + "\" has " + std::to_string(all->size()) + " values; one is expected");
    return static_cast<T>(all->front());
}

/// A list of points or vectors V, whose components are `Stored` in the parameter.
template <class V, class Stored> std::vector<V> Arguments::vectors(const std::string& name) const {
    const std::vector<Stored>* all = values<Stored>(name);
    if (!all) return {};
    static_assert(std::is_same_v<typename V::value_type, Stored>);
    constexpr size_t components = sizeof(V) / sizeof(Stored);
    if (all->size() % components)
        throw SceneError(whereOf(name), "\"" + given(name)->declaration() + "\" has " + std::to_string(all->size()) +
                                            " values; a multiple of " + std::to_string(components) + " is expected");
    std::vector<V> result(all->size() / components);
    std::memcpy(static_cast<void*>(result.data()), all->data(), all->size() * sizeof(Stored));
    return result;
}

bool Arguments::flag(const std::string& name) const { return single<bool>(name).value_or(rule(name).fallback == "true"); }

double Arguments::number(const std::string& name) const {
    const std::string& fallback = rule(name).fallback;
    return number(name, fallback.empty() ? 0 : std::stod(fallback));
}
double Arguments::number(const std::string& name, double fallback) const { return single<double>(name).value_or(fallback); }

int Arguments::integer(const std::string& name) const {
    const std::string& fallback = rule(name).fallback;
    return single<int>(name).value_or(fallback.empty() ? 0 : std::stoi(fallback));
}

std::string Arguments::text(const std::string& name) const { return single<std::string>(name).value_or(rule(name).fallback); }

glm::dvec3 Arguments::vector(const std::string& name) const { return vector(name, glm::dvec3(0)); }
glm::dvec3 Arguments::vector(const std::string& name, glm::dvec3 fallback) const {
    if (!has(name)) return fallback;
    std::vector<glm::dvec3> all;
    if (given(name)->type == ParameterType::point3) all = points3(name);
    else for (const glm::vec3& v : vectors3(name)) all.push_back(v);
    if (all.size() != 1)
        throw SceneError(whereOf(name),
                         "\"" + given(name)->declaration() + "\" has " + std::to_string(3 * all.size()) + " values; three are expected");
    return all.front();
}

std::vector<double> Arguments::numbers(const std::string& name) const {
    const auto* all = values<double>(name);
    return all ? *all : std::vector<double>();
}
std::vector<int> Arguments::integers(const std::string& name) const {
    const auto* all = values<int>(name);
    return all ? *all : std::vector<int>();
}
std::vector<std::string> Arguments::texts(const std::string& name) const {
    const auto* all = values<std::string>(name);
    return all ? *all : std::vector<std::string>();
}
std::vector<glm::vec2> Arguments::vectors2(const std::string& name) const { return vectors<glm::vec2, float>(name); }
std::vector<glm::vec3> Arguments::vectors3(const std::string& name) const { return vectors<glm::vec3, float>(name); }
std::vector<glm::dvec3> Arguments::points3(const std::string& name) const {
    std::vector<glm::dvec3> points = vectors<glm::dvec3, double>(name);
    constexpr double most = std::numeric_limits<float>::max();
    for (const glm::dvec3& p : points)
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(p[axis]) > most)
                throw SceneError(whereOf(name), "\"" + given(name)->declaration() + "\" has a coordinate " + shown(p[axis]) +
                                                    ", which is too large for a floating-point number; at most " + shown(most) +
                                                    " would work");
    return points;
}

std::vector<glm::vec3> Arguments::colors(const std::string& name) const {
    const std::vector<double> all = numbers(name);
    const auto problem = [&](const std::string& what) {
        return SceneError(whereOf(name), "\"" + given(name)->declaration() + "\" has " + what);
    };
    if (all.size() % 3) throw problem(std::to_string(all.size()) + " values; a multiple of 3 is expected");
    if (std::ranges::any_of(all, [](double component) { return component < 0; })) throw problem("a component below 0");
    std::vector<glm::vec3> result(all.size() / 3);
    for (size_t i = 0; i < result.size(); ++i) result[i] = {all[3 * i], all[3 * i + 1], all[3 * i + 2]};
    return result;
}

/// The default spectrum of a rule.
static Spectrum defaultSpectrum(const Rule& rule) {
    if (auto curve = namedSpectrum(rule.fallback)) return Spectrum::sampled(curve);
    return Spectrum::constant(std::stod(rule.fallback));
}

/// A spectrum may be a reflectance at some wavelengths only.
void Arguments::warnOfImpossible(const Parameter& parameter, const Spectrum& reflectance) const {
    const DenseCurve values = reflectance.dense();
    const auto most = std::ranges::max_element(values);
    if (*most > 1)
        reading_->diagnostics.warn(
            parameter.where,
            fmt::format("\"{}\" is {} at {:.0f} nm: it would reflect more than it receives; what is above 1 counts as 1",
                        parameter.declaration(), shown(*most), shortestWavelength + static_cast<double>(most - values.begin())));
}

Spectrum Arguments::spectrum(const std::string& name, const Spectrum& fallback) const {
    const Rule& r = rule(name);
    if (const Parameter* parameter = given(name)) {
        if (parameter->type == ParameterType::number) return Spectrum::constant(*single<double>(name));
        const Spectrum spectrum = reading_->readSpectrum(*parameter);
        if (r.wanted == Wanted::colorMap && parameter->type == ParameterType::rgb) {
            const auto& rgb = std::get<std::vector<double>>(parameter->values);
            if (std::ranges::any_of(rgb, [](double component) { return component > 1; }))
                throw SceneError(parameter->where,
                                 "\"" + parameter->declaration() + "\" has a component above 1: it would reflect more than it receives");
        }
        if (r.wanted == Wanted::colorMap && parameter->type == ParameterType::spectrum)
            warnOfImpossible(*parameter, spectrum);
        return spectrum;
    }
    return r.fallback.empty() ? fallback : defaultSpectrum(r);
}

std::optional<std::string> Arguments::file(const std::string& name) const {
    const std::string path = text(name);
    return path.empty() ? std::nullopt : reading_->findFile(path, whereOf(name));
}

std::optional<std::string> Arguments::file(const std::string& name, const char* instead) const {
    const std::string path = text(name);
    return path.empty() ? std::nullopt : reading_->findFile(path, whereOf(name), instead);
}

std::optional<ImageFile> Arguments::image(const std::string& name) const {
    const std::string path = text(name);
    return path.empty() ? std::nullopt : reading_->findImage(path, whereOf(name));
}

std::string typeOf(const ParameterList& parameters, const char* directive, const SourceLocation& where) {
    for (const Parameter& parameter : parameters | std::views::reverse)
        if (parameter.name == "type" && parameter.type == ParameterType::text) {
            parameter.isUsed = true;
            return std::get<std::vector<std::string>>(parameter.values).front();
        }
    throw SceneError(where, std::string(directive) + " needs a \"string type\"");
}

}  // namespace eikonal::pbrt
