#include "app/render_output.h"

#include "app/output.h"
#include "background.h"
#include "film/fireflies.h"
#include "film/projection.h"
#include "image/half_floats.h"
#include "image/image_file.h"
#include "image/sample_variance.h"
#include "kinds/camera_kind.h"
#include "messages.h"
#include "names.h"
#include "standard_stream.h"
#include "wait_notice.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>

namespace eikonal {

RenderOutput::RenderOutput(const Options& options, const Session& session, std::vector<std::string> files, const Aovs& aovs)
    : options_(options), session_(session), files_(std::move(files)), aovs_(aovs),
      hash_(inBackground([&session] { return sceneHash(session.packed()); }).share()) {
    if (!options.output.denoise) return;
    try {
        denoiser_.emplace(options.device.threads);
    } catch (const Error&) {
        undenoised_ = std::current_exception();
        tell(LogLevel::warning, "Intel Open Image Denoise is missing: the image will stay noisy", options.log);
    }
}

void describeFilm(Metadata& metadata, const FilmTotals::Samples& samples, const ErrorEstimate& error, ErrorMetric metric) {
    metadata.samples = static_cast<int>(samples.fewest);
    if (samples.most > samples.fewest) metadata.meanSamples = samples.mean;
    metadata.error = error.error;
    metadata.errorLow = error.low;
    metadata.errorHigh = error.high;
    metadata.errorMetric = nameIn(errorMetricNames, metric);
    metadata.errorDoubt = error.doubt;
}

void tellFireflies(Metadata& metadata, const FilmImage& image, LogLevel log) {
    if (image.fireflies.empty()) return;
    metadata.firefliesShare = firefliesShare(image.fireflies, image.color);
    const double percent = 100 * *metadata.firefliesShare;
    tellResult(fmt::format("fireflies: {:.2g} % of the light was taken from the image, into the layer fireflies", percent), log);
}

FilmImage developImage(const FilmTotals& totals, const PackedScene& scene, const FilmDescription& film, const Aovs& aovs,
                       const ImageEncoding& encoding) {
    FilmImage image = totals.develop(scene);
    if (aovs.variance && encoding.channelNames == ChannelNames::pbrt) addSampleVariance(image);
    selectAovs(image, aovs);
    image.halfFloats = film.halfFloats;
    if (film.gbuffer == GBuffer::cameraSpace) toCameraSpace(image, scene);
    return image;
}

void warnOfClamping(const FilmImage& image, const ImageEncoding& encoding, const SourceLocation& where, Diagnostics& diagnostics) {
    if (!encoding.halfFloats.value_or(image.halfFloats)) return;
    const auto count = std::ranges::count_if(image.color, [](const glm::vec3& c) { return std::max({c.r, c.g, c.b}) > mostHalf; });
    if (count)
        diagnostics.warn(where, fmt::format("{} pixel{} brighter than {}, the most that 16-bit floats hold; in EXR files {} clamped: "
                                            "--pixel-type float, or \"bool savefp16\" false, keeps all",
                                            count, count == 1 ? " is" : "s are", mostHalf, count == 1 ? "it is" : "they are"));
}

/// A matrix row by row, as pbrt-v4 stores it.
static std::array<float, 16> rowByRow(const glm::dmat4& matrix) {
    std::array<float, 16> rows;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) rows[static_cast<size_t>(4 * row + column)] = static_cast<float>(matrix[column][row]);
    return rows;
}

/// The camera, as pbrt-v4 describes it.
static void describeCamera(Metadata& metadata, const CameraDescription& camera, const PackedScene& packed) {
    const glm::dmat4 world = cameraFromWorld(packed);
    metadata.worldToCamera = rowByRow(world);
    if (const auto project = kindOf(camera).traits.screenFromCamera) {
        const glm::dmat4 ndcFromScreen = glm::translate(glm::dmat4(1), glm::dvec3(0.5)) * glm::scale(glm::dmat4(1), glm::dvec3(0.5));
        metadata.worldToNdc = rowByRow(ndcFromScreen * project(camera) * world);
    }
}

StoredMetadata RenderOutput::metadata() {
    Metadata m;
    m.targetError = options_.output.targetError;
    m.seed = session_.scene().sampler.seed;
    m.version = "Eikonal " EIKONAL_VERSION;
    m.scene = options_.scene.path;
    m.sceneHash = hash_.get();
    m.device = session_.deviceNames();
    m.biasedChoices = describe(session_.biasedChoices());
    describeCamera(m, session_.scene().camera, session_.packed());
    return {m, aovs_, options_.output.errorMetric};
}

ImageReport RenderOutput::report(const FilmTotals& totals, double seconds) {
    const ErrorMetric metric = options_.output.errorMetric;
    ImageReport report{totals.samples(), totals.error(metric), metadata().metadata};
    /* Samples do not tell of a bias that they all have */
    if (session_.packed().features.has(Feature::MERGING) && report.error.doubt.empty())
        report.error.doubt = "the bias of merged light paths is not in it";
    describeFilm(report.metadata, report.samples, report.error, metric);
    report.metadata.renderSeconds = seconds;
    report.metadata.commandLine = options_.commandLine;
    return report;
}

FilmImage RenderOutput::develop(const FilmTotals& totals, bool withErrors) const {
    Aovs aovs = aovs_;
    aovs.variance |= withErrors;
    aovs.sampleCount |= withErrors;
    return developImage(totals, session_.packed(), session_.scene().film, aovs, options_.output.encoding);
}

/// Whether the image has changed.
bool RenderOutput::denoise(FilmImage& image) {
    if (!denoiser_) return false;
    try {
        const WaitNotice notice("denoising", !showsProgress(options_.log));
        denoiser_->denoise(image);
        undenoised_ = nullptr;
        return true;
    } catch (const Error&) {
        undenoised_ = std::current_exception();
        return false;
    }
}

void RenderOutput::writeSoFar(FilmImage image, Metadata metadata) {
    std::vector<std::string> files = files_;
    std::erase_if(files, isStandardStream);
    metadata.partial = "the render goes on";
    if (!files.empty()) write(std::move(image), std::move(metadata), files);
}

void RenderOutput::write(FilmImage image, Metadata metadata, const std::vector<std::string>& files) {
    if (denoise(image)) metadata.biasedChoices = withChoice(metadata.biasedChoices, denoisingChoice);
    std::string problems;
    for (const std::string& file : files) {
        const WaitNotice notice("writing " + file, !showsProgress(options_.log));
        try {
            writeImage(file, image, metadata, options_.output.encoding);
        } catch (const Error& error) {
            problems += (problems.empty() ? "" : "\n") + std::string(error.what());
        }
    }
    if (!problems.empty()) throw Error(ExitCode::scene, problems);
}

}  // namespace eikonal
