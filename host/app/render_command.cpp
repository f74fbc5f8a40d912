#include "app/commands.h"
#include "app/interrupt.h"
#include "app/render_jobs.h"
#include "app/render_scene.h"
#include "app/tell_error.h"
#include "error.h"

#include <cstdio>

namespace eikonal {

/// The worse of two exit statuses: an error is worse than a partial image; of two errors the first counts.
static int worse(int first, int second) {
    const auto rank = [](int status) { return status == 0 ? 0 : status == static_cast<int>(ExitCode::partialImage) ? 1 : 2; };
    return rank(second) > rank(first) ? second : first;
}

int renderCommand(const Options& o) {
    const std::vector<Options> jobs = renderJobs(o);
    std::shared_ptr<OpenDevice> device;
    WrittenImages written;
    if (jobs.size() == 1) return renderScene(jobs.front(), device, written);
    int status = 0;
    for (const Options& job : jobs) {
        try {
            const int ended = renderScene(job, device, written);
            status = worse(status, ended);
            if (ended > signalStatus) return ended;
        } catch (...) {
            const int failed = tellError(job.scene.path);
            status = worse(status, failed);
            if (failed == static_cast<int>(ExitCode::device) && !device) return status;  // it will not open for the others, either
        }
        std::fflush(stdout);
    }
    return status;
}

}  // namespace eikonal
