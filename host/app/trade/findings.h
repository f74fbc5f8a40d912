#pragma once
// What a study has found: errors of its points, models of its settings, and what to recommend.

#include "app/trade/model.h"
#include "app/trade/study.h"
#include "image/tone_map.h"

#include <vector>

namespace eikonal {

struct Findings {
    References references;
    ToneMapping mapping;  ///< of pictures and FLIP: an exposure that shows the image
    std::vector<MeasuredPoint> points;
    std::vector<SettingModel> models;  ///< of the settings that have points
    double significant = 0;            ///< chances below it are significant: 1 % for all settings together
    std::vector<Recommendation> recommendations;
};

/// The errors of what has been measured, with FLIP or without. Reads the images of all points. Throws an Error (ExitCode::scene) if there
/// is not even a point of the user's own options.
Findings measureErrors(const Study& study, bool withFlip);
/// Fills in what follows from the errors, and from the runs at full size so far: times, models, the front and recommendations.
void predict(const Study& study, const std::vector<Wish>& wishes, Findings& findings);

/// Runs the settings that would be recommended at full size, until the budget is spent or the recommendations stay the same.
void confirmRecommendations(Study& study, const std::vector<Wish>& wishes);

/// What the points say of a setting that more samples do not change. `point`: its representative (report.h).
enum class Verdict { none, better, worse };
Verdict efficiencyVerdict(const Findings& findings, const MeasuredPoint& point);
/// Whether a setting that is unbiased by construction has a bias that is significant.
bool isUnexpectedlyBiased(const Findings& findings, const Setting& setting, const MeasuredPoint& point);

/// `eikonal render ...`: renders the user's image with a setting.
std::string commandOf(const Study& study, size_t setting, double rung);
/// The first of the renders that a point was measured by.
std::string measuredCommand(const Study& study, size_t setting, double rung);
/// What makes a recommendation less certain: "; extrapolated from ..."; empty: nothing.
std::string caveats(const Recommendation& recommendation);
/// "for 30 s: eikonal render ...: 28.9 s, error 1.3 %".
std::string describe(const Study& study, const Recommendation& recommendation);

}  // namespace eikonal
