#include "app/render_output.h"

#include "app/output.h"
#include "film/projection.h"
#include "image/image_file.h"
#include "names.h"
#include "wait_notice.h"

namespace eikonal {

RenderOutput::RenderOutput(const Options& options, const Session& session, std::vector<std::string> files, const Aovs& aovs)
    : options_(options), session_(session), files_(std::move(files)), aovs_(aovs),
      hash_(std::async(std::launch::async, [&session] { return sceneHash(session.packed()); }).share()) {}

ImageReport RenderOutput::report(const Film& film, double seconds) {
    const ErrorMetric metric = options_.output.errorMetric;
    ImageReport report{film.samples(), film.error(metric), {}};
    Metadata& m = report.metadata;
    m.samples = static_cast<int>(report.samples.fewest);
    if (report.samples.most > report.samples.fewest) m.meanSamples = report.samples.mean;
    m.targetError = options_.output.targetError;
    m.error = report.error.error;
    m.errorLow = report.error.low;
    m.errorHigh = report.error.high;
    m.errorMetric = nameIn(errorMetricNames, metric);
    m.errorDoubt = report.error.doubt;
    m.renderSeconds = seconds;
    m.seed = session_.scene().sampler.seed;
    m.version = "Eikonal " EIKONAL_VERSION;
    m.scene = options_.scene.path;
    m.sceneHash = hash_.get();
    m.device = session_.context().device().name;
    m.biasedChoices = describe(session_.biasedChoices());
    m.commandLine = options_.commandLine;
    return report;
}

FilmImage RenderOutput::develop(const Film& film) const {
    FilmImage image = session_.develop(film);
    selectAovs(image, aovs_);
    if (session_.scene().film.gbuffer == GBuffer::cameraSpace) toCameraSpace(image, session_.packed());
    return image;
}

void RenderOutput::write(const FilmImage& image, const Metadata& metadata) const {
    std::string problems;
    for (const std::string& file : files_) {
        const WaitNotice notice("writing " + file, options_.log < LogLevel::warning);
        try {
            writeImage(file, image, metadata, options_.output.toneMapping);
        } catch (const Error& error) {
            problems += (problems.empty() ? "" : "\n") + std::string(error.what());
        }
    }
    if (!problems.empty()) throw Error(ExitCode::scene, problems);
}

}  // namespace eikonal
