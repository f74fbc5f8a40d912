#pragma once
// Statistics of a render, as text.

#include "film/totals.h"
#include "available_memory.h"
#include "render/session.h"

namespace eikonal {

/// For example "1.5 GiB".
std::string readableBytes(double bytes);
/// "scene tables 12.0 MiB, queues ...".
std::string describe(const MemoryPlan& plan);
/// The most memory, in bytes, that a render on a processor will occupy: while its hierarchies are built, or later with queues and film.
/// occupied: what this process has taken, once the scene is packed. Within 10 % with PoCL 3.1 (docs/performance.md).
size_t mostMemory(const MemoryPlan& plan, const OccupiedMemory& occupied);
/// "--roulette root --roulette-scale 1.5 --roulette-depth 3".
std::string asOptions(const Roulette& roulette);
/// What --stats prints: time and memory by part. error: describe(ErrorEstimate). The caller measures `renderSeconds` and `writeSeconds`.
std::string describeRun(const Session& session, const Profile& profile, const FilmTotals::Samples& samples, const std::string& error,
                        double renderSeconds, double writeSeconds);

}  // namespace eikonal
