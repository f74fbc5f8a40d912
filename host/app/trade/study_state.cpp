#include "app/trade/study_state.h"

#include "error.h"
#include "image/atomic_file.h"
#include "json_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace eikonal {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SeedResult, seed, renderSeconds, meanSamples, ownError, squaredError, mean)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Point, setting, rung, seeds, prepareSeconds, compileSeconds, compiledKernels, isSameImage, failure)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Confirmation, setting, rung, wallSeconds, renderSeconds, compileSeconds, meanSamples, ownError,
                                   errorDeviation, failure)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Setting, knob, value, options, addsBias, isBiased, ladder, compiles)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StudyState, scene, sceneHash, version, device, baseOptions, full, studied, pathSeconds, prepareSeconds,
                                   brightness, spentSeconds, lookSeconds, referenceSamples, referenceSeconds, reference, settings, points,
                                   confirmations)

using Json = nlohmann::json;

double StudyState::ladderTop() const {
    double top = 0;
    for (const Point& p : points)
        if (settings[p.setting].ladder == Ladder::samples) top = std::max(top, p.rung);
    return top;
}

Point* StudyState::find(size_t setting, double rung) {
    const auto found = std::ranges::find_if(points, [&](const Point& p) { return p.setting == setting && p.rung == rung; });
    return found == points.end() ? nullptr : &*found;
}

std::vector<const Point*> StudyState::ladderOf(size_t setting, int seeds) const {
    std::vector<const Point*> ladder;
    for (const Point& p : points)
        if (p.setting == setting && p.failure.empty() && static_cast<int>(p.seeds.size()) >= seeds) ladder.push_back(&p);
    std::ranges::sort(ladder, {}, [](const Point* p) { return p->meanSamples(); });
    return ladder;
}

void StudyState::save(const std::string& file) const { writeTextAtomically(file, jsonText(Json(*this), 1) + "\n"); }

/// Throws if a study of `found` cannot go on as one of `expected`.
static void checkSame(const std::string& file, const char* what, const std::string& found, const std::string& expected) {
    if (found != expected)
        throw Error(ExitCode::scene,
                    fmt::format("\"{}\" is a study of another {}: \"{}\", not \"{}\"; remove its folder or choose another -o", file, what,
                                found, expected));
}

std::optional<StudyState> StudyState::load(const std::string& file, const StudyState& expected) {
    std::ifstream in(file);
    if (!in) return std::nullopt;
    StudyState s;
    try {
        s = Json::parse(in).get<StudyState>();
    } catch (const nlohmann::json::exception& error) {
        throw Error(ExitCode::scene,
                    fmt::format("\"{}\" is not a study that can go on ({}); remove its folder or choose another -o", file, error.what()));
    }
    checkSame(file, "scene (its content has changed)", s.sceneHash, expected.sceneHash);
    checkSame(file, "version", s.version, expected.version);
    checkSame(file, "device", s.device, expected.device);
    checkSame(file, "set of options", fmt::format("{}", fmt::join(s.baseOptions, " ")),
              fmt::format("{}", fmt::join(expected.baseOptions, " ")));
    return s;
}

}  // namespace eikonal
