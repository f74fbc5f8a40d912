#pragma once
// The result of a render as JSON, for programs.

#include "film/totals.h"
#include "image/film_image.h"
#include "render/render.h"
#include "render/session.h"

#include <string>
#include <vector>

namespace eikonal {

/// What `eikonal render --json` prints: one JSON object. `endedBy`: the signal that ended the render, or 0.
std::string describeAsJson(const Session& session, const std::vector<std::string>& files, const Metadata& metadata,
                           const FilmTotals::Samples& samples, const RenderResult& result, int endedBy, double writeSeconds,
                           const std::vector<std::string>& warnings);

}  // namespace eikonal
