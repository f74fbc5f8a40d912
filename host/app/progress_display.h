#pragma once
// How a render goes on, for users and programs, in the forms of --progress.

#include "app/render_place.h"
#include "film/noise.h"
#include "messages.h"
#include "render/render.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// 75.4 as "1:15", 4000 as "1:06:40".
std::string clockTime(double seconds);

/// What a line of progress says, the most important first.
std::vector<std::string> progressParts(const Progress& progress, unsigned samples, const RenderPlace& place = {});
/// A bar with as many of the parts as fit into `width` characters, from a width of 5 on.
std::string progressBar(double fraction, std::vector<std::string> parts, int width);

/// Shows progress on standard error, and in the log file.
class ProgressDisplay {
public:
    struct Subject {
        unsigned samples;    ///< the maximum per pixel
        ErrorMetric metric;
        /// The error of the image so far; unset: unknown. Called seldom, in the forms that tell it.
        std::function<std::optional<ErrorEstimate>()> error;
        RenderPlace place;   ///< told if there are several renders
    };
    ProgressDisplay(Subject subject, bool isShown);
    /// Ends the bar's line.
    ~ProgressDisplay();

    /// Counts are rounded down, so that nothing is done before it is.
    void show(Progress progress);
    /// The render is over. isFinished: all samples are taken, or the error is small enough.
    void end(bool isFinished);

private:
    std::vector<std::string> partsOf(const Progress& p) const { return progressParts(p, subject_.samples, subject_.place); }
    void print(const Progress& progress);
    void printJson(const Progress& progress);
    void printOpenJd(const Progress& progress);
    const std::optional<ErrorEstimate>& error(const Progress& progress);

    Subject subject_;
    bool isShown_;
    ProgressForm form_;
    Progress last_;
    double shownAt_, loggedAt_ = 0;
    double errorDue_ = 0;                  ///< when the next estimate may be made
    std::optional<ErrorEstimate> error_;   ///< the last one
    double percent_ = 0;                   ///< openjd: what was printed; it never falls
};

}  // namespace eikonal
