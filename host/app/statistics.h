#pragma once
// Figures about a render, as lines of text.

#include "render/session.h"

namespace eikonal {

/// Bytes as people read them: "1.5 GiB".
std::string readableBytes(double bytes);
/// "scene tables 12.0 MiB, queues ...".
std::string describe(const MemoryPlan& plan);
/// "--roulette root --roulette-scale 1.5 --roulette-depth 3".
std::string asOptions(const Roulette& roulette);
/// What --stats prints: where time and memory went. `renderSeconds` and `writeSeconds` as measured by the caller.
std::string describeRun(const Session& session, const Profile& profile, const Film::Samples& samples, const RenderResult& result, double renderSeconds, double writeSeconds);

}  // namespace eikonal
