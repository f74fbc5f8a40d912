#include "scene/pbrt/reading.h"

#include "scene/pbrt/source.h"

#include <algorithm>
#include <filesystem>

namespace eikonal::pbrt {
namespace {

namespace fs = std::filesystem;

/// A curve from wavelengths and values in turn.
SampledCurve toCurve(const std::vector<double>& numbers, const SourceLocation& where) {
    if (numbers.size() % 2) throw SceneError(where, "a spectrum is pairs of a wavelength in nm and a value; these are " + std::to_string(numbers.size()) + " numbers");
    SampledCurve curve;
    for (size_t i = 0; i < numbers.size(); i += 2) {
        if (i > 0 && !(numbers[i] > numbers[i - 2]))
            throw SceneError(where, "the wavelengths of a spectrum must ascend: " + std::to_string(numbers[i]) + " follows " + std::to_string(numbers[i - 2]));
        curve.wavelengths.push_back(numbers[i]);
        curve.values.push_back(numbers[i + 1]);
    }
    return curve;
}

/// The numbers of a spectrum file: text, "#" starts a comment.
SampledCurve readCurve(const std::string& path, std::string text) {
    TokenStream tokens;
    tokens.push(path, std::move(text));
    std::vector<double> numbers;
    for (Token token = tokens.next(); token.kind != Token::Kind::end; token = tokens.next())
        numbers.push_back(tokens.toNumber<double>(token, "a number"));
    const SourceLocation where{std::make_shared<const std::string>(path)};
    if (numbers.empty()) throw SceneError(where, "this spectrum file has no numbers");
    return toCurve(numbers, where);
}

}  // namespace

std::optional<std::string> Reading::findFile(const std::string& name, const SourceLocation& where) {
    std::vector<fs::path> candidates = {fs::path(folder) / name};  // an absolute name stays what it is
    if (where.file) candidates.push_back(fs::path(*where.file).parent_path() / name);
    candidates.push_back(name);
    std::error_code ignored;
    for (const fs::path& candidate : candidates)
        if (!name.empty() && fs::is_regular_file(candidate, ignored)) return candidate.lexically_normal().string();
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
    const auto fail = [&](const std::string& message) { throw SceneError(parameter.where, "\"" + parameter.declaration() + "\" " + message); };
    if (const auto* names = std::get_if<std::vector<std::string>>(&parameter.values)) {
        if (names->size() != 1) fail("names " + std::to_string(names->size()) + " spectra; one is expected");
        const std::string& name = names->front();
        if (auto curve = namedSpectrum(name)) return Spectrum::sampled(curve);
        if (name.find('.') == name.npos && name.find('/') == name.npos) {
            const std::string near = nearestWord(name, spectrumNames());
            fail("names \"" + name + "\", which is neither a spectrum of pbrt-v4 nor a file" + (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
        }
        const std::optional<std::string> path = findFile(name, parameter.where);
        if (!path) return Spectrum::constant(0);
        auto& curve = spectrumFiles_[*path];
        if (!curve) curve = std::make_shared<const SampledCurve>(readCurve(*path, readTextFile(*path)));
        return Spectrum::sampled(curve);
    }

    const auto& numbers = std::get<std::vector<double>>(parameter.values);
    if (parameter.type == ParameterType::rgb) {
        if (numbers.size() != 3) fail("has " + std::to_string(numbers.size()) + (numbers.size() == 1 ? " value" : " values") + "; three are expected");
        if (numbers[0] < 0 || numbers[1] < 0 || numbers[2] < 0) fail("has a negative component");
        return Spectrum::rgb({numbers[0], numbers[1], numbers[2]}, parameter.space);
    }
    if (parameter.type == ParameterType::blackbody) {
        if (numbers.size() == 2) throw Version3Error(parameter.where, "a \"blackbody\" with a scale beside its temperature", "\"float scale\" for lights");
        if (numbers.size() != 1) fail("has " + std::to_string(numbers.size()) + " values; one temperature in kelvin is expected");
        if (!(numbers[0] > 0)) fail("has a temperature that is not above 0 K");
        return Spectrum::blackbody(numbers[0]);
    }
    if (numbers.size() == 2) diagnostics.warn(parameter.where, "\"" + parameter.declaration() + "\" is not 0 at a single wavelength only, so it is black");
    return Spectrum::sampled(toCurve(numbers, parameter.where));
}

}  // namespace eikonal::pbrt
