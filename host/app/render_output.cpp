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

void describeFilm(Metadata& metadata, const Film::Samples& samples, const ErrorEstimate& error, ErrorMetric metric) {
    metadata.samples = static_cast<int>(samples.fewest);
    if (samples.most > samples.fewest) metadata.meanSamples = samples.mean;
    metadata.error = error.error;
    metadata.errorLow = error.low;
    metadata.errorHigh = error.high;
    metadata.errorMetric = nameIn(errorMetricNames, metric);
    metadata.errorDoubt = error.doubt;
}

StoredMetadata RenderOutput::metadata() {
    Metadata m;
    m.targetError = options_.output.targetError;
    m.seed = session_.scene().sampler.seed;
    m.version = "Eikonal " EIKONAL_VERSION;
    m.scene = options_.scene.path;
    m.sceneHash = hash_.get();
    m.device = session_.context().device().name;
    m.biasedChoices = describe(session_.biasedChoices());
    return {m, aovs_, options_.output.errorMetric};
}

ImageReport RenderOutput::report(const Film& film, double seconds) {
    const ErrorMetric metric = options_.output.errorMetric;
    const FilmTotals totals = film.totals();
    ImageReport report{totals.samples(), totals.error(metric), metadata().metadata};
    describeFilm(report.metadata, report.samples, report.error, metric);
    report.metadata.renderSeconds = seconds;
    report.metadata.commandLine = options_.commandLine;
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
