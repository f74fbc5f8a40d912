#pragma once
// Statistics of a render, as text.

#include "film/totals.h"
#include "render/session.h"

namespace eikonal {

/// For example "1.5 GiB".
std::string readableBytes(double bytes);
/// "scene tables 12.0 MiB, queues ...".
std::string describe(const MemoryPlan& plan);
/// "--roulette root --roulette-scale 1.5 --roulette-depth 3".
std::string asOptions(const Roulette& roulette);
/// What --stats prints: time and memory by part. error: describe(ErrorEstimate). The caller measures `renderSeconds` and `writeSeconds`.
std::string describeRun(const Session& session, const Profile& profile, const FilmTotals::Samples& samples, const std::string& error,
                        double renderSeconds, double writeSeconds);

}  // namespace eikonal
