#pragma once
// What a study has found, as files.

#include "app/trade/findings.h"

#include <string>

namespace eikonal {

/// One page that needs no other files and no network: curves, pictures, tables and command lines.
std::string asHtml(const Study& study, const Findings& findings);
/// One row for each point, with a header.
std::string asCsv(const Study& study, const Findings& findings);
/// Everything but the pictures.
std::string asJson(const Study& study, const Findings& findings);

/// The point that a setting is shown and compared by: with as many samples as the user's own options have at `rung`, or else the longest of
/// its ladder; null if it has none. `own`: the rung of the user's own options that all are compared at.
const MeasuredPoint* representative(const Findings& findings, const StudyState& state, size_t setting, double own);
/// The longest rung at which the user's own options and most other settings have been measured.
double commonRung(const Findings& findings, const StudyState& state);

}  // namespace eikonal
