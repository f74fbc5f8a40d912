#include "app/trade/setting_renderer.h"

#include "clock.h"
#include "names.h"
#include "render/render.h"

#include <fmt/format.h>

namespace eikonal {

Options renderOptions(const std::string& scene, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"eikonal", "render", scene};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return parseOptions(arguments);
}

std::string studyMetricOption() { return fmt::format("--error-metric={}", nameIn(errorMetricNames, studyMetric)); }

static Options quiet(Options options) {
    options.log = LogLevel::silent;
    return options;
}

SettingRenderer::SettingRenderer(const std::string& scene, const std::vector<std::string>& options)
    : options_(quiet(renderOptions(scene, options))), session_(options_, diagnostics_) {
    const Stopwatch time;
    session_.load();
    session_.pack({});
    session_.prepare();
    prepareSeconds_ = time.seconds() - session_.times().compile;
}

TimedImage SettingRenderer::render(int seed, const std::function<bool()>& stop) {
    session_.setSeed(seed);
    Film film(session_.packed());
    RenderControl control;
    control.endSample = static_cast<unsigned>(session_.packed().samples);
    control.targetError = options_.output.targetError;
    control.errorMetric = options_.output.errorMetric;
    control.stop = control.abandon = stop;
    const Stopwatch time;
    session_.survey(stop);
    const RenderResult result = eikonal::render(session_.renderDevices(), film, control);
    TimedImage timed;
    timed.renderSeconds = time.seconds();
    timed.isFinished = result.isFinished;
    const FilmTotals totals = film.totals();
    timed.meanSamples = totals.samples().mean;
    timed.ownError = totals.error(studyMetric).error;
    timed.image = totals.develop(session_.packed());
    return timed;
}

}  // namespace eikonal
