#pragma once
// The image files of a render, which may be written several times while it goes on.

#include "app/options.h"
#include "app/stored_metadata.h"
#include "film/totals.h"
#include "image/denoise.h"
#include "render/session.h"

#include <exception>
#include <future>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// The part of metadata that follows from a film.
void describeFilm(Metadata& metadata, const FilmTotals::Samples& samples, const ErrorEstimate& error, ErrorMetric metric);
/// Stores how much of the image's light re-weighting has taken, and prints it. Nothing, unless fireflies were to be re-weighted.
void tellFireflies(Metadata& metadata, const FilmImage& image, LogLevel log);

/// The image to write, with the channels that are asked for.
FilmImage developImage(const FilmTotals& totals, const PackedScene& scene, const FilmDescription& film, const Aovs& aovs,
                       const ImageEncoding& encoding);
/// Warns if colours are too bright for 16 bits, with which the image is to be stored.
void warnOfClamping(const FilmImage& image, const ImageEncoding& encoding, const SourceLocation& where, Diagnostics& diagnostics);

/// What is known about the image that a film has now.
struct ImageReport {
    FilmTotals::Samples samples;
    ErrorEstimate error;
    Metadata metadata;
};

class RenderOutput {
public:
    /// Of a session that is packed. All arguments but the last two must outlive this object.
    RenderOutput(const Options& options, const Session& session, std::vector<std::string> files, const Aovs& aovs);

    /// What is known before anything is rendered.
    StoredMetadata metadata();
    /// seconds: of rendering so far.
    ImageReport report(const FilmTotals& totals, double seconds);
    /// withErrors: also with variance and sampleCount, whether or not they are asked for.
    FilmImage develop(const FilmTotals& totals, bool withErrors = false) const;
    /// Why the last image written is as noisy as before although it was to be denoised; null: it is not.
    std::exception_ptr undenoised() const { return undenoised_; }
    /// Writes all files, denoised if that is asked for and can be done; even if one of them fails; then throws one Error with all problems.
    void write(FilmImage image, Metadata metadata) { write(std::move(image), std::move(metadata), files_); }
    /// The same while the render goes on: standard output, which holds one image, waits for the last.
    void writeSoFar(FilmImage image, Metadata metadata);

private:
    void write(FilmImage image, Metadata metadata, const std::vector<std::string>& files);
    bool denoise(FilmImage& image);

    const Options& options_;
    const Session& session_;
    std::vector<std::string> files_;
    Aovs aovs_;
    std::shared_future<std::string> hash_;
    std::optional<Denoiser> denoiser_;
    std::exception_ptr undenoised_;
};

}  // namespace eikonal
