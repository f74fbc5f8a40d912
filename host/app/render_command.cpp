#include "app/commands.h"
#include "app/existing_images.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "app/render_jobs.h"
#include "app/render_scene.h"
#include "app/run_summary.h"
#include "app/tell_error.h"
#include "error.h"
#include "messages.h"
#include "read/formats/kept_images.h"

#include <fmt/format.h>

#include <cstdio>

namespace eikonal {

/// The worse of two exit statuses: an error is worse than a partial image; of two errors the first counts.
static int worse(int first, int second) {
    const auto rank = [](int status) { return status == 0 ? 0 : status == static_cast<int>(ExitCode::partialImage) ? 1 : 2; };
    return rank(second) > rank(first) ? second : first;
}

/// Renders one scene, unless its images are there and are not to be rendered again.
static int renderJob(const Options& o, OpenDevices& devices, WrittenImages& written) {
    if (!o.output.skipExisting || !hasWholeImages(o)) return renderScene(o, devices, written);
    const std::vector<std::string> files = imageFiles(o.output.files, o.output.encoding);
    tellResult(fmt::format("skipped {}: {} there", jobName(o.scene), files.size() == 1 ? "the image is" : "the images are"), o.log);
    if (o.json) std::fputs(describeSkipped(o, files).c_str(), stdout);
    return static_cast<int>(ExitCode::success);
}

int renderCommand(const Options& o) {
    std::vector<RenderJob> jobs = renderJobs(o);
    int status = 0;
    for (const std::string& line : takeMissing(jobs)) {
        tell(LogLevel::error, "error: " + line);
        status = static_cast<int>(ExitCode::scene);
    }
    OpenDevices devices;
    WrittenImages written;
    const bool isAlone = o.scenes.size() == 1 && o.frames.size() <= 1;
    for (size_t i = 0; i < jobs.size(); ++i) {
        const Options own = optionsOf(o, jobs, i);
        if (isAlone) return renderJob(own, devices, written);
        keepImages();
        try {
            const int ended = renderJob(own, devices, written);
            status = worse(status, ended);
            if (ended > signalStatus) return ended;
        } catch (...) {
            const int failed = tellError(jobName(own.scene));
            status = worse(status, failed);
            if (failed == static_cast<int>(ExitCode::device) && devices.empty()) return status;  // it will not open for the others, either
        }
        std::fflush(stdout);
    }
    return status;
}

}  // namespace eikonal
