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
    std::vector<Recommendation> recommendations;
};

/// Analyses what has been measured. withFlip: also by FLIP, which takes time. Throws an Error (ExitCode::scene) if there is not even a
/// point of the user's own options.
Findings analyse(Study& study, const std::vector<Wish>& wishes, bool withFlip = true);

/// Runs the settings that would be recommended at full size, until the budget is spent or the recommendations stay the same.
void confirmRecommendations(Study& study, const std::vector<Wish>& wishes);

/// `eikonal render ...`: renders the user's image with a setting.
std::string commandOf(const Study& study, size_t setting, double rung);
/// The first of the renders that a point was measured by.
std::string measuredCommand(const Study& study, size_t setting, double rung);
/// What makes a recommendation less certain: "; extrapolated from ..."; empty: nothing.
std::string caveats(const Recommendation& recommendation);
/// "for 30 s: eikonal render ...: 28.9 s, error 1.3 %".
std::string describe(const Study& study, const Recommendation& recommendation);

}  // namespace eikonal
