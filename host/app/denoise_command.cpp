#include "app/commands.h"
#include "app/output.h"
#include "app/render_output.h"
#include "clock.h"
#include "error.h"
#include "image/denoise.h"
#include "image/image_file.h"
#include "image/sample_variance.h"
#include "messages.h"
#include "render/biased_choices.h"

#include <fmt/format.h>

#include <filesystem>

namespace eikonal {

int denoiseCommand(const Options& o) {
    std::vector<std::string> files = o.output.files;
    if (files.empty())
        files.push_back(std::filesystem::path(o.image).replace_extension().string() + "-denoised." + chosenExtension(o.output.encoding));
    files = imageFiles(std::move(files), o.output.encoding);
    checkEncoding(files, o.output.encoding);
    for (const std::string& file : files) checkWritable(file, 0, o.output.encoding);
    FilmFile file = readImage(o.image);
    for (const std::string& name : files) checkHolds(name, file.image.columns(), file.image.rows(), o.output.encoding);
    Denoiser(o.device.threads).denoise(file.image);
    if (o.output.encoding.channelNames == ChannelNames::pbrt && !file.image.variance.empty())
        addSampleVariance(file.image, file.metadata.meanSamples.value_or(file.metadata.samples.value_or(1)));
    Diagnostics diagnostics(o.log);
    warnOfClamping(file.image, o.output.encoding, {}, diagnostics);
    file.metadata.biasedChoices = withChoice(file.metadata.biasedChoices, denoisingChoice);
    for (const std::string& name : files) writeImage(name, file.image, file.metadata, o.output.encoding);
    tellResult(fmt::format("wrote {} in {:.1f} s", fmt::join(files, " and "), secondsSinceStart()), o.log);
    return static_cast<int>(ExitCode::success);
}

}  // namespace eikonal
