#include "read/pbrt/reading.h"

#include "read/pbrt/source.h"
#include "color/observer.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal::pbrt {
namespace {

namespace fs = std::filesystem;

/// A curve from alternating wavelengths and values; whereOf(i) is the place of number i. Throws SceneError.
template <class WhereOf> SampledCurve toCurve(const std::vector<double>& numbers, const SourceLocation& where, WhereOf&& whereOf) {
    if (numbers.size() % 2)
        throw SceneError(where, fmt::format("a spectrum is pairs of a wavelength in nm and a value; {} number{}", numbers.size(),
                                            numbers.size() == 1 ? " is not a pair" : "s are not pairs"));
    SampledCurve curve;
    for (size_t i = 0; i < numbers.size(); i += 2) {
        if (i > 0 && !(numbers[i] > numbers[i - 2]))
            throw SceneError(whereOf(i),
                             fmt::format("the wavelengths of a spectrum must ascend: {:g} follows {:g}", numbers[i], numbers[i - 2]));
        curve.wavelengths.push_back(numbers[i]);
        curve.values.push_back(numbers[i + 1]);
    }
    return curve;
}

/// Reads a spectrum file: numbers as text, with comments after "#".
SampledCurve readCurve(const std::string& path, std::string text) {
    TokenStream tokens;
    tokens.push(path, std::move(text));
    std::vector<double> numbers;
    std::vector<SourceLocation> places;
    for (Token token = tokens.next(); token.kind != Token::Kind::end; token = tokens.next()) {
        numbers.push_back(tokens.toNumber<double>(token, "a number"));
        places.push_back(tokens.locate(token));
    }
    const SourceLocation where{std::make_shared<const std::string>(path)};
    if (numbers.empty()) throw SceneError(where, "this spectrum file has no numbers");
    return toCurve(numbers, where, [&](size_t i) { return places[i]; });
}

/// Warns of curves that are probably mistakes. Values below 0 become 0.
void checkCurve(SampledCurve& curve, const std::string& title, const SourceLocation& where, Diagnostics& diagnostics) {
    const size_t lowest = static_cast<size_t>(std::ranges::min_element(curve.values) - curve.values.begin());
    if (curve.values[lowest] < 0) {
        diagnostics.warn(
            where, fmt::format("{} is {:g} at {:g} nm; values below 0 count as 0", title, curve.values[lowest], curve.wavelengths[lowest]));
        for (double& value : curve.values) value = std::max(value, 0.);
    }
    const auto isDark = [](double value) { return value == 0; };
    if (!std::ranges::all_of(curve.values, isDark) && std::ranges::all_of(densify(curve), isDark))
        diagnostics.warn(where, fmt::format("{} is black: it is 0 at {}, {}, ... {} nm, where spectra are sampled", title,
                                            shortestWavelength, shortestWavelength + 1, longestWavelength));
}

/// The spectrum names for messages, without the channels of sensors.
std::string commonSpectra() {
    std::string names;
    for (const std::string& name : spectrumNames())
        if (name.starts_with("glass-") || name.starts_with("illum-") || name.starts_with("metal-") || name.starts_with("stdillum-"))
            names += name + ", ";
    return names;
}

}  // namespace

std::vector<fs::path> Reading::candidatesFor(const std::string& name, const SourceLocation& where) const {
    std::vector<fs::path> candidates = {fs::path(folder) / name};  // an absolute name stays unchanged
    if (where.file) candidates.push_back(fs::path(*where.file).parent_path() / name);
    candidates.push_back(name);
    return candidates;
}

bool Reading::hasFile(const std::string& name, const SourceLocation& where) const {
    std::error_code ignored;
    return !name.empty() && std::ranges::any_of(candidatesFor(name, where),
                                                [&](const fs::path& candidate) { return fs::is_regular_file(candidate, ignored); });
}

std::optional<std::string> Reading::lookFor(const std::string& name, const SourceLocation& where) {
    std::error_code ignored;
    for (const fs::path& candidate : candidatesFor(name, where))
        if (!name.empty() && fs::is_regular_file(candidate, ignored)) return candidate.lexically_normal().string();
    std::optional<std::string> found = findLoosely(name, folder);
    if (found) unsupported("loose file " + name, where, looseMatchMessage(name, *found));
    return found;
}

std::optional<std::string> Reading::findFile(const std::string& name, const SourceLocation& where, const char* instead) {
    if (missingFiles == MissingFiles::error) return findFile(name, where);
    std::optional<std::string> found = lookFor(name, where);
    if (!found) diagnostics.warnOnce("missing file " + name, where, fmt::format("there is no file \"{}\"; {}", name, instead));
    return found;
}

std::optional<ImageFile> Reading::findImage(const std::string& name, const SourceLocation& where) {
    ImageFile image;
    if (const auto path = findFile(name, where, "the texture is magenta")) image.path = *path;
    else if (missingFiles == MissingFiles::magenta) image = magentaImage(name);
    else return std::nullopt;
    image.where = where;
    return image;
}

std::string Reading::includedText(const std::string& path) {
    constexpr size_t longest = 1 << 16, most = 1 << 26;
    if (const auto known = includedTexts_.find(path); known != includedTexts_.end()) return known->second;
    std::string text = readTextFile(path);
    if (text.size() <= longest && includedBytes_ + text.size() <= most) {
        includedTexts_[path] = text;
        includedBytes_ += text.size();
    }
    return text;
}

std::optional<std::string> Reading::findFile(const std::string& name, const SourceLocation& where) {
    if (auto found = lookFor(name, where)) return found;
    const std::vector<fs::path> candidates = candidatesFor(name, where);
    std::error_code ignored;
    if (!name.empty() && std::ranges::any_of(candidates, [&](const fs::path& candidate) { return fs::is_directory(candidate, ignored); }))
        problems.add(where, "\"" + name + "\" is a folder; a file is expected");
    else
        problems.addMissingFile(where, name);
    return std::nullopt;
}

void Reading::unsupported(const std::string& kind, const SourceLocation& where, const std::string& message) {
    problems.guard([&] { diagnostics.unsupported(kind, where, message); });
}

Spectrum Reading::readSpectrum(const Parameter& parameter) {
    const auto fail = [&](const std::string& message) {
        throw SceneError(parameter.where, "\"" + parameter.declaration() + "\" " + message);
    };
    if (const auto* names = std::get_if<std::vector<std::string>>(&parameter.values)) {
        if (names->size() != 1) fail("names " + std::to_string(names->size()) + " spectra; one is expected");
        const std::string& name = names->front();
        if (auto curve = namedSpectrum(name)) return Spectrum::sampled(curve);
        if (name.find('.') == name.npos && name.find('/') == name.npos && !hasFile(name, parameter.where)) {
            const std::string near = nearestWord(name, spectrumNames());
            fail("names \"" + name + "\", which is neither a spectrum of pbrt-v4 nor a file; " +
                 (near.empty() ? "it can be " + commonSpectra() + "or a file of wavelengths in nm and values"
                               : "did you mean \"" + near + "\"?"));
        }
        const std::optional<std::string> path = findFile(name, parameter.where);
        if (!path) return Spectrum::constant(0);
        auto& curve = spectrumFiles_[*path];
        if (!curve) {
            SampledCurve read = readCurve(*path, readTextFile(*path));
            checkCurve(read, "this spectrum", {std::make_shared<const std::string>(*path)}, diagnostics);
            curve = std::make_shared<const SampledCurve>(std::move(read));
        }
        return Spectrum::sampled(curve);
    }

    const auto& numbers = std::get<std::vector<double>>(parameter.values);
    if (parameter.type == ParameterType::rgb) {
        if (numbers.size() != 3)
            fail("has " + std::to_string(numbers.size()) + (numbers.size() == 1 ? " value" : " values") + "; three are expected");
        if (numbers[0] < 0 || numbers[1] < 0 || numbers[2] < 0) fail("has a negative component");
        return Spectrum::rgb({numbers[0], numbers[1], numbers[2]}, parameter.space);
    }
    if (parameter.type == ParameterType::blackbody) {
        if (numbers.size() == 2)
            throw Version3Error(parameter.where, "a \"blackbody\" with a scale beside its temperature", "\"float scale\" for lights");
        if (numbers.size() != 1) fail("has " + std::to_string(numbers.size()) + " values; one temperature in kelvin is expected");
        if (!(numbers[0] > 0)) fail("has a temperature that is not above 0 K");
        return Spectrum::blackbody(numbers[0]);
    }
    SampledCurve curve = toCurve(numbers, parameter.where, [&](size_t) { return parameter.where; });
    checkCurve(curve, "\"" + parameter.declaration() + "\"", parameter.where, diagnostics);
    return Spectrum::sampled(std::move(curve));
}

}  // namespace eikonal::pbrt
