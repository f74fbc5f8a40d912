// The page of a study.

#include "app/trade/pictures.h"
#include "app/trade/report.h"
#include "app/trade/svg_plot.h"
#include "image/flip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

constexpr const char* head = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1">
<title>{}</title>
<style>
:root{{color-scheme:light dark;--line:#8884;--soft:#8882}}
body{{font:15px/1.5 system-ui,sans-serif;margin:0 auto;max-width:1100px;padding:1rem}}
h1{{font-size:1.5rem;margin:.2em 0}} h2{{font-size:1.15rem;margin:2em 0 .4em;border-bottom:1px solid var(--line)}}
code{{font:13px/1.4 ui-monospace,monospace;background:var(--soft);padding:.1em .3em;overflow-wrap:anywhere}}
table{{border-collapse:collapse;font-size:13px}} .wide{{overflow-x:auto}}
th,td{{text-align:right;white-space:nowrap;padding:.2em .6em;border-bottom:1px solid var(--line);vertical-align:top}}
th:first-child,td:first-child,td.text,th.text{{text-align:left;white-space:normal}} tr.own{{font-weight:600}}
svg{{width:100%;height:auto}} .legend{{display:flex;flex-wrap:wrap;gap:.2em 1.2em;font-size:13px}}
.legend i{{display:inline-block;width:1.4em;height:.25em;vertical-align:middle;margin-right:.4em}}
.pictures{{display:grid;grid-template-columns:repeat(auto-fill,minmax(300px,1fr));gap:1rem}}
figure{{margin:0}} figure div{{display:flex;gap:4px}} figure img{{width:0;flex:1;image-rendering:pixelated;min-width:0}}
figcaption{{font-size:13px}} .note{{font-size:13px;opacity:.8}}
</style></head><body>
)";

/// A colour for each knob, readable on white and on black.
std::string colorOf(size_t knob) {
    static constexpr const char* colors[] = {"#d62728", "#1f77b4", "#2ca02c", "#ff7f0e", "#9467bd", "#17a2b8",
                                             "#8c564b", "#e377c2", "#7f9f00", "#00897b", "#c79100", "#5c6bc0"};
    return colors[knob % std::size(colors)];
}

/// Knobs in the order of their settings.
std::vector<std::string> knobsOf(const StudyState& state) {
    std::vector<std::string> knobs;
    for (const Setting& s : state.settings)
        if (std::ranges::find(knobs, s.knob) == knobs.end()) knobs.push_back(s.knob);
    return knobs;
}

size_t knobIndex(const std::vector<std::string>& knobs, const Setting& s) {
    return static_cast<size_t>(std::ranges::find(knobs, s.knob) - knobs.begin());
}

std::string percent(double value) { return fmt::format("{:.2g} %", value * 100); }

/// A root of a square that may be negative by noise: "1.2 %", or "< 0.4 %" if zero is within the interval.
std::string biasText(const Interval& square) {
    if (square.low <= 0) return fmt::format("&lt; {}", percent(std::sqrt(std::max(square.high, 0.))));
    return percent(std::sqrt(square.value));
}

/// "0.93 to 1.02".
std::string rangeText(const Interval& i) { return fmt::format("{:.2f} to {:.2f}", i.low, i.high); }

std::string energyText(const Interval& energy) {
    return fmt::format("{:+.2f} &plusmn; {:.2f} %", energy.value * 100, (energy.high - energy.low) / 2 * 100);
}

std::string slopeText(const SettingModel& m) {
    if (m.rungs < 2) return "&ndash;";
    return fmt::format("{:.2f} &plusmn; {:.2f}", m.slope.value, (m.slope.high - m.slope.low) / 2);
}

class Page {
public:
    Page(const Study& study, const Findings& findings)
        : study_(study),
          state_(study.state()),
          found_(findings),
          reference_(findings.references.mean()),
          knobs_(knobsOf(state_)),
          rung_(commonRung(findings, state_)) {}

    std::string text() {
        text_ = fmt::format(head, escaped("Accuracy against time: " + state_.scene));
        writeSummary();
        writeWishes();
        writePlot();
        writeTable();
        writePictures();
        writePoints();
        writeMethod();
        return text_ + "</body></html>\n";
    }

private:
    const SettingModel* modelOf(size_t setting) const {
        const auto found = std::ranges::find(found_.models, setting, &SettingModel::setting);
        return found == found_.models.end() ? nullptr : &*found;
    }

    void writeSummary() {
        text_ += fmt::format("<h1>Accuracy against time: {}</h1>\n<p>{} x {} pixels on {}. ", escaped(state_.scene), state_.full[0],
                             state_.full[1], escaped(state_.device));
        if (state_.studied != state_.full)
            text_ += fmt::format("Measured at {} x {}; times are those of the whole image, by runs at full size. ", state_.studied[0],
                                 state_.studied[1]);
        text_ += fmt::format(
            "Errors are roots of relMSE, against a reference with an error of {} ({:.0f} samples, two independent halves). "
            "{:.0f} s were spent of {:.0f} s.</p>\n",
            percent(found_.references.relativeError()), 2 * state_.referenceSamples, state_.spentSeconds, study_.request().budgetSeconds);
    }

    void writeWishes() {
        text_ +=
            "<h2>What to use</h2>\n<div class=\"wide\"><table><tr><th>for</th><th "
            "class=\"text\">command</th><th>time</th><th>error</th></tr>\n";
        for (const Recommendation& r : found_.recommendations) {
            if (!r.isPossible) {
                text_ += fmt::format("<tr><td>{}</td><td class=\"text\" colspan=\"3\">nothing that was measured {}</td></tr>\n",
                                     r.wish.text(), r.wish.kind == Wish::Kind::error ? "reaches this error" : "is so fast");
                continue;
            }
            text_ += fmt::format("<tr><td>{}</td><td class=\"text\"><code>{}</code></td><td>{:.3g} s</td><td>{} &plusmn; {}{}</td></tr>\n",
                                 r.wish.text(), escaped(commandOf(study_, r.setting, r.rung)), r.seconds, percent(r.error),
                                 percent(r.error * r.uncertainty), caveats(r));
        }
        text_ += "</table></div>\n";
    }

    void writePlot() {
        Plot plot{
            .xLabel = "seconds for the whole image, with compiled kernels", .yLabel = "error (root of relMSE)", .curves = {}, .front = {}};
        for (size_t setting = 0; setting < state_.settings.size(); ++setting) {
            const Setting& s = state_.settings[setting];
            PlotCurve curve{s.name(), setting == 0 ? "currentColor" : colorOf(knobIndex(knobs_, s)), {}, setting == 0};
            for (const MeasuredPoint& p : found_.points)
                if (p.setting == setting)
                    curve.points.push_back(
                        {p.seconds, p.relativeError(), std::sqrt(std::max(p.error.square.low, 0.)),
                         std::sqrt(std::max(p.error.square.high, 0.)),
                         fmt::format("{}, {:.4g} samples: {:.3g} s, {}", s.name(), p.samples, p.seconds, percent(p.relativeError()))});
            if (!curve.points.empty()) plot.curves.push_back(curve);
        }
        for (const MeasuredPoint& p : found_.points)
            if (p.isOnFront) plot.front.push_back({p.seconds, p.relativeError(), 0, 0, ""});
        std::ranges::sort(plot.front, {}, &PlotPoint::x);
        text_ +=
            "<h2>Error against time</h2>\n<p>Lower and further left is better. The dashed line is the Pareto front: nothing that was "
            "measured "
            "has less error in less time. Point at a mark to see what it is.</p>\n" +
            asSvg(plot) + "<p class=\"legend\">";
        for (size_t k = 0; k < knobs_.size(); ++k)
            text_ +=
                fmt::format("<span><i style=\"background:{}\"></i>{}</span>", k == 0 ? "currentColor" : colorOf(k), escaped(knobs_[k]));
        text_ += "</p>\n";
    }

    void writeTable() {
        const MeasuredPoint* own = representative(found_, state_, 0, rung_);
        text_ += fmt::format(
            "<h2>Each setting at {:g} samples</h2>\n<p>Efficiency is 1 / (relMSE x seconds of rendering), relative to the options as "
            "given: above 1 is "
            "better. Both are rendered with the same seeds, so the interval is that of the paired ratio, which is narrower than those of "
            "its "
            "parts; a verdict is significant at {:.2g} (1 % shared by all settings), and so is a change of energy with a star. A bias that "
            "is called significant, of a setting that should have none, is an error of the program: please report it. "
            "Bias is what more samples do not remove; energy is the mean of the image against the reference's. The slope is that "
            "of the "
            "logarithm of the variance over that of the samples, from at least two rungs and a normal prior of -1.05 &plusmn; 0.2: -1 for "
            "independent samples.</p>\n<div class=\"wide\"><table>"
            "<tr><th>setting</th><th>error</th><th>bias</th><th>energy</th><th>FLIP</th><th>seconds</th><th>efficiency</th><th>95 "
            "%</th><th>verdict</th><th>energy, as "
            "given = 0</th><th>slope</th>"
            "<th>samples</th><th>seeds</th></tr>\n",
            rung_, found_.significant);
        for (size_t setting = 0; setting < state_.settings.size(); ++setting) {
            const MeasuredPoint* p = representative(found_, state_, setting, rung_);
            const SettingModel* m = modelOf(setting);
            if (!p || !m) continue;
            const double gain =
                own->error.square.value * own->secondsPerPath * own->samples / (p->error.square.value * p->secondsPerPath * p->samples);
            const Verdict verdict = efficiencyVerdict(found_, *p);
            const bool isWrong = isUnexpectedlyBiased(found_, state_.settings[setting], *p);
            text_ += fmt::format(
                "<tr{}><td>{}</td><td>{} &plusmn; {}</td><td>{}</td><td>{}</td><td>{:.3f}</td><td>{:.3g}</td><td>{:.2f}</td>"
                "<td>{}</td><td class=\"text\">{}</td><td>{}</td><td>{}</td><td>{:.4g}</td><td>{}</td></tr>\n",
                setting == 0 ? " class=\"own\"" : "", escaped(state_.settings[setting].name()), percent(p->relativeError()),
                percent(p->relativeError() * (p->error.square.high - p->error.square.low) / 4 / p->error.square.value),
                biasText(p->error.biasSquare) + (isWrong ? ", <b>significant</b>" : ""), energyText(p->error.energy), p->flip, p->seconds,
                gain, p->paired ? rangeText(p->paired->efficiency) : "",
                verdict == Verdict::better  ? "better"
                : verdict == Verdict::worse ? "worse"
                                            : "",
                p->paired ? energyText(p->paired->energy) + (p->paired->chanceOfEnergy < found_.significant ? " *" : "") : "",
                slopeText(*m), p->samples, p->seeds);
        }
        text_ += "</table></div>\n";
    }

    void writePictures() {
        text_ +=
            "<h2>Pictures</h2>\n<p>One render of each setting; beside it, the mean of its renders minus the reference, relative (red: too "
            "bright, "
            "blue: too dark, full colour at 25 %); then FLIP of the render (the brighter, the more visible).</p>\n<div "
            "class=\"pictures\">\n";
        text_ += fmt::format("<figure><div><img alt=\"reference\" src=\"{}\"></div><figcaption>reference</figcaption></figure>\n",
                             picture(reference_, found_.mapping));
        for (size_t setting = 0; setting < state_.settings.size(); ++setting) {
            const MeasuredPoint* p = representative(found_, state_, setting, rung_);
            if (!p) continue;
            Point point;
            point.setting = setting;
            point.rung = p->rung;
            point.seeds.resize(static_cast<size_t>(p->seeds));
            const PointImages images = study_.loadImages(point);
            text_ += fmt::format(
                "<figure><div><img alt=\"render\" src=\"{}\"><img alt=\"bias\" src=\"{}\"><img alt=\"FLIP\" src=\"{}\"></div>"
                "<figcaption>{}, {:.4g} samples</figcaption></figure>\n",
                picture(images.first, found_.mapping), differencePicture(images.sums.mean, reference_, 0.25), heatPicture(images.first),
                escaped(state_.settings[setting].name()), p->samples);
        }
        text_ += "</div>\n";
    }

    std::string heatPicture(const FilmImage& image) const {
        const std::vector<float> flip = flipMap(image, reference_, found_.mapping);
        FilmImage heat = reference_;
        for (size_t i = 0; i < heat.color.size(); ++i) heat.color[i] = heatColor(flip[i]);
        return storedPicture(heat);
    }

    void writePoints() {
        text_ +=
            "<h2>Every point</h2>\n<details><summary>Commands, times and errors</summary><div class=\"wide\"><table>"
            "<tr><th>command</th><th>relMSE</th><th>bias&sup2;</th><th>variance</th><th>render s</th><th>load s</th><th>compile "
            "s</th><th>all, warm</th>"
            "<th>on the front</th></tr>\n";
        const double pixels = pixelsOf(state_.studied);
        for (const MeasuredPoint& p : found_.points)
            text_ += fmt::format(
                "<tr><td><code>{}</code></td><td>{:.3g} ({:.2g} to {:.2g})</td><td>{:.2g} ({:.2g} to "
                "{:.2g})</td><td>{:.3g}</td><td>{:.3g}</td>"
                "<td>{:.2g}</td><td>{}</td><td>{:.3g}</td><td>{}</td></tr>\n",
                escaped(measuredCommand(study_, p.setting, p.rung)), p.error.square.value, p.error.square.low, p.error.square.high,
                p.error.biasSquare.value, p.error.biasSquare.low, p.error.biasSquare.high, p.error.variance,
                p.secondsPerPath * p.samples * pixels, p.prepareSeconds,
                p.compiledKernels ? fmt::format("{:.2g} ({} kernels)", p.compileSeconds, p.compiledKernels) : "cached", p.seconds,
                p.isOnFront ? "yes" : "");
        text_ += "</table></div></details>\n";
        std::string missing;
        for (size_t setting = 0; setting < state_.settings.size(); ++setting)
            if (!modelOf(setting)) missing += (missing.empty() ? "" : "; ") + escaped(state_.settings[setting].name());
        for (const Point& p : state_.points)
            if (!p.failure.empty())
                text_ += fmt::format("<p>{} failed: {}</p>\n", escaped(state_.settings[p.setting].name()), escaped(p.failure));
        if (!missing.empty()) text_ += fmt::format("<p>Not measured, for lack of time or because of an error: {}.</p>\n", missing);
    }

    void writeMethod() {
        text_ += fmt::format(
            "<h2>How this was measured</h2>\n<p class=\"note\">Each point is rendered with up to {} seeds, at two different times, in turn "
            "with the "
            "others. For an image a and two independent references r and r', the mean of (a - r)(a - r') is the squared error of a without "
            "the references' "
            "noise. Squares are divided by r&sup2; + 0.01 mean(r)&sup2;. Bias&sup2; is that of the mean of the seeds minus the variance "
            "that is left in it. "
            "Intervals hold 95 %. The reference has the options <code>{}</code>. Variance is modelled as a power of the samples, time as a "
            "line; predictions of "
            "times come from runs of the whole command at full size where there was time for one.</p>\n",
            Study::seeds, escaped(joined(state_.reference)));
    }

    static std::string joined(const std::vector<std::string>& words) {
        std::string text;
        for (const std::string& w : words) text += (text.empty() ? "" : " ") + w;
        return text;
    }

    const Study& study_;
    const StudyState& state_;
    const Findings& found_;
    const FilmImage reference_;
    const std::vector<std::string> knobs_;
    const double rung_;

    std::string text_;
};

}  // namespace

std::string asHtml(const Study& study, const Findings& findings) { return Page(study, findings).text(); }

}  // namespace eikonal
