#pragma once
// The result of a render as JSON, for programs.

#include "app/options.h"
#include "film/totals.h"
#include "image/film_image.h"
#include "render/render_identity.h"
#include "render/session.h"

#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// How a render went, beside what its session knows.
struct RunSummary {
    std::vector<std::string> files;        ///< images that were written
    std::string checkpoint;                ///< that holds the samples; empty: none
    bool isComplete = true;                ///< no samples are missing
    int endedBy = 0;                       ///< a signal, or 0
    int status = 0;                        ///< exit status
    Metadata metadata;
    FilmTotals::Samples samples;
    RenderIdentity identity;
    double writeSeconds = 0;
    std::vector<std::string> warnings;
    std::optional<int> frame;
};

/// What `eikonal render --json` prints: one line with one JSON object.
std::string describeAsJson(const Session& session, const RunSummary& run);
/// The same of a render whose images are there already.
std::string describeSkipped(const Options& options, const std::vector<std::string>& files);

}  // namespace eikonal
