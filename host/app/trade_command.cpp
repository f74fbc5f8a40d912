#include "app/commands.h"
#include "app/interrupt.h"
#include "app/progress_display.h"
#include "app/trade/findings.h"
#include "app/trade/report.h"
#include "clock.h"
#include "image/atomic_file.h"
#include "messages.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

namespace eikonal {
namespace {

/// One line on a terminal that is drawn over, otherwise a line every ten seconds.
class StudyLine {
public:
    explicit StudyLine(bool silent) : silent_(silent) {}
    ~StudyLine() {
        endStatus(false);
    }
    void show(const StudyProgress& p) {
        if (silent_) return;
        constexpr int width = 20;
        const auto filled = static_cast<size_t>(p.fraction * width);
        const std::string bar = std::string(filled, '#') + std::string(width - filled, '-');
        const std::string text =
            fmt::format("[{}] {:3.0f} % of the budget, {} left: {}", bar, p.fraction * 100, clockTime(p.secondsLeft), p.what);
        if (progressForm() == ProgressForm::bar) {
            drawStatus(text);
        } else if (time_.seconds() >= next_) {
            printProgress(text);
            next_ = time_.seconds() + 10;
        }
    }

private:
    const bool silent_;
    double next_ = 0;
    const Stopwatch time_;
};

/// The page's name without its extension; `asked`: what -o says.
std::string stemFor(const std::string& asked, const std::string& scene) {
    std::filesystem::path page = asked;
    if (asked.empty()) {
        page = std::filesystem::path(scene).filename();
        if (page.extension() == ".gz") page = page.stem();
        page.replace_extension();
        page += "-trade.html";
    }
    if (page.extension() != ".html" && page.extension() != ".htm")
        throw UsageError(fmt::format("-o names a page, \"{}.html\" for example, not \"{}\"", page.stem().string(), page.string()));
    return (page.parent_path() / page.stem()).string();
}

}  // namespace

int tradeCommand(const Options& o) {
    const std::string stem = stemFor(o.output.files.empty() ? "" : o.output.files.front(), o.scene.path);
    for (const char* extension : {".html", ".csv", ".json"}) checkFileWritable(stem + extension, 0);
    const Interrupt interrupt;
    StudyLine line(o.log < LogLevel::warning);
    Study::Request request{o.scene.path,
                           o.passedOn,
                           stem + ".study",
                           o.compilerFlags,
                           o.budget,
                           [] { return Interrupt::signal() != 0; },
                           [&](const StudyProgress& p) { line.show(p); },
                           o.log};
    Study study(request);
    study.run();
    if (study.isInterrupted() && study.state().ladderOf(0).empty()) {
        tell(LogLevel::error, "interrupted before anything was measured");
        return signalStatus + Interrupt::signal();
    }
    confirmRecommendations(study, o.wishes);
    Findings findings = measureErrors(study, true);
    predict(study, o.wishes, findings);
    writeTextAtomically(stem + ".html", asHtml(study, findings));
    writeTextAtomically(stem + ".csv", asCsv(study, findings));
    writeTextAtomically(stem + ".json", asJson(study, findings));
    std::string text = fmt::format("wrote {0}.html, {0}.csv and {0}.json\n", stem);
    for (const Recommendation& r : findings.recommendations) text += describe(study, r) + "\n";
    std::fputs(text.c_str(), stdout);
    if (Interrupt::signal()) {
        tell(LogLevel::error, fmt::format("interrupted; the same command goes on where it was, with what is in {}.study", stem));
        return signalStatus + Interrupt::signal();
    }
    return static_cast<int>(ExitCode::success);
}

}  // namespace eikonal
