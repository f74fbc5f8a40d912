#pragma once
// Renders one setting of a scene with several seeds, in this process.

#include "app/options.h"
#include "image/film_image.h"
#include "render/session.h"

#include <functional>
#include <string>
#include <vector>

namespace eikonal {

/// The options of `eikonal render SCENE options...`. Throws a UsageError.
Options renderOptions(const std::string& scene, const std::vector<std::string>& options);

/// How a study measures errors: what relMSE of an image is relative to follows its mean.
constexpr ErrorMetric studyMetric = ErrorMetric::scaledRelmseRoot;
/// "--error-metric=...".
std::string studyMetricOption();

/// An image and what it took, in seconds.
struct TimedImage {
    FilmImage image;
    double renderSeconds = 0;
    double meanSamples = 0;    ///< per pixel
    double ownError = 0;  ///< by its own samples, in studyMetric
    bool isFinished = true;    ///< false: interrupted
};

/// A session with the kernels and tables of one setting.
class SettingRenderer {
public:
    /// Loads the scene and compiles its kernels. Warnings are not printed: the user's own scene has printed them before. Throws Error.
    SettingRenderer(const std::string& scene, const std::vector<std::string>& options);

    /// Renders with a seed. `stop`: asked often; true ends the render early.
    TimedImage render(int seed, const std::function<bool()>& stop);

    double compileSeconds() const { return session_.times().compile; }
    int compiledKernels() const { return session_.compiledStages(); }
    double prepareSeconds() const { return prepareSeconds_; }  ///< to load, pack, build and upload the scene
    Session& session() { return session_; }

private:
    Options options_;
    Diagnostics diagnostics_{LogLevel::silent};
    Session session_;
    double prepareSeconds_ = 0;
};

}  // namespace eikonal
