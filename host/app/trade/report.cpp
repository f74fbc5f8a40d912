#include "app/trade/report.h"
#include "json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace eikonal {

using Json = nlohmann::ordered_json;

const MeasuredPoint* representative(const Findings& findings, const StudyState& state, size_t setting, double own) {
    const MeasuredPoint* last = nullptr;
    for (const MeasuredPoint& p : findings.points) {
        if (p.setting != setting) continue;
        last = &p;
        if (state.settings[setting].ladder == Ladder::samples && p.rung == own) return last;
    }
    return last;
}

double commonRung(const Findings& findings, const StudyState& state) {
    double best = 0;
    size_t most = 0;
    for (const MeasuredPoint& p : findings.points) {
        if (p.setting != 0) continue;
        const auto count = static_cast<size_t>(std::ranges::count_if(findings.points, [&](const MeasuredPoint& q) {
            return q.rung == p.rung && state.settings[q.setting].ladder == Ladder::samples;
        }));
        if (2 * count >= most || p.rung <= best) {
            best = std::max(best, p.rung);
            most = std::max(most, count);
        }
    }
    return best;
}

static std::string nameOf(Verdict verdict) {
    return verdict == Verdict::better ? "better" : verdict == Verdict::worse ? "worse" : "not significant";
}

static Json asJson(const Interval& i) { return {{"value", i.value}, {"low", i.low}, {"high", i.high}}; }

static std::string columns(const Interval& i) { return fmt::format("{:.6g},{:.6g},{:.6g}", i.value, i.low, i.high); }

std::string asCsv(const Study& study, const Findings& findings) {
    std::string csv =
        "knob,value,command,measuredCommand,samples,seeds,seconds,renderSecondsPerPath,prepareSeconds,compileSeconds,compiledKernels,"
        "relMSE,relMSELow,"
        "relMSEHigh,"
        "biasSquare,biasSquareLow,biasSquareHigh,variance,energy,energyLow,energyHigh,flip,isOnFront,"
        "chanceOfBias,errorRatio,errorRatioLow,errorRatioHigh,secondsRatio,secondsRatioLow,secondsRatioHigh,efficiencyRatio,"
        "efficiencyRatioLow,efficiencyRatioHigh,chanceOfEfficiency,energyChange,energyChangeLow,energyChangeHigh\n";
    const auto quote = [](const std::string& text) {
        std::string all = "\"";
        for (char c : text) all += c == '"' ? "\"\"" : std::string(1, c);
        return all + "\"";
    };
    for (const MeasuredPoint& p : findings.points) {
        const Setting& s = study.state().settings[p.setting];
        const TrueError& e = p.error;
        csv += fmt::format(
            "{},{},{},{},{:g},{},{:.6g},{:.6g},{:.4g},{:.4g},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:."
            "6g},{},{:.3g}",
            quote(s.knob), quote(s.value), quote(commandOf(study, p.setting, p.rung)), quote(measuredCommand(study, p.setting, p.rung)),
            p.samples, p.seeds, p.seconds, p.secondsPerPath, p.prepareSeconds, p.compileSeconds, p.compiledKernels, e.square.value,
            e.square.low, e.square.high, e.biasSquare.value, e.biasSquare.low, e.biasSquare.high, e.variance, e.energy.value, e.energy.low,
            e.energy.high, p.flip, p.isOnFront ? 1 : 0, e.chanceOfBias);
        if (const auto& d = p.paired; d)
            csv += fmt::format(",{},{},{},{:.3g},{}\n", columns(d->error), columns(d->seconds), columns(d->efficiency),
                               d->chanceOfEfficiency, columns(d->energy));
        else csv += ",,,,,,,,,,,,,\n";
    }
    return csv;
}

std::string asJson(const Study& study, const Findings& findings) {
    const StudyState& state = study.state();
    Json json{{"scene", state.scene},
              {"sceneHash", state.sceneHash},
              {"version", state.version},
              {"device", state.device},
              {"options", state.baseOptions},
              {"size", state.full},
              {"measuredSize", state.studied},
              {"budgetSeconds", study.request().budgetSeconds},
              {"spentSeconds", state.spentSeconds}};
    json["significantChance"] = findings.significant;
    json["reference"] = {
        {"samples", state.referenceSamples}, {"relativeError", findings.references.relativeError()}, {"options", state.reference}};
    for (const Recommendation& r : findings.recommendations) {
        Json one{{"wish", r.wish.text()}, {"isPossible", r.isPossible}};
        if (r.isPossible)
            one.update({{"setting", state.settings[r.setting].name()},
                        {"command", commandOf(study, r.setting, r.rung)},
                        {"samples", r.samples},
                        {"seconds", r.seconds},
                        {"error", r.error},
                        {"uncertainty", r.uncertainty},
                        {"isReliable", r.isReliable},
                        {"isBetter", r.isBetter},
                        {"extrapolation", r.extrapolation}});
        json["recommendations"].push_back(one);
    }
    for (const SettingModel& m : findings.models)
        json["settings"].push_back({{"setting", state.settings[m.setting].name()},
                                    {"isBiased", !m.isExact},
                                    {"biasSquare", m.biasSquare},
                                    {"varianceOfOneSample", m.variance1},
                                    {"slope", asJson(m.slope)},
                                    {"fixedSeconds", m.fixedSeconds},
                                    {"secondsPerSample", m.secondsPerSample}});
    for (const MeasuredPoint& p : findings.points) {
        const Setting& s = state.settings[p.setting];
        const TrueError& e = p.error;
        json["points"].push_back({{"setting", s.name()},
                                  {"command", commandOf(study, p.setting, p.rung)},
                                  {"measuredCommand", measuredCommand(study, p.setting, p.rung)},
                                  {"samples", p.samples},
                                  {"seeds", p.seeds},
                                  {"seconds", p.seconds},
                                  {"renderSecondsPerPath", p.secondsPerPath},
                                  {"prepareSeconds", p.prepareSeconds},
                                  {"compileSeconds", p.compileSeconds},
                                  {"compiledKernels", p.compiledKernels},
                                  {"relativeMse", asJson(e.square)},
                                  {"biasSquare", asJson(e.biasSquare)},
                                  {"variance", e.variance},
                                  {"energy", asJson(e.energy)},
                                  {"flip", p.flip},
                                  {"isOnFront", p.isOnFront},
                                  {"chanceOfBias", e.chanceOfBias},
                                  {"isUnexpectedlyBiased", isUnexpectedlyBiased(findings, s, p)}});
        if (p.paired)
            json["points"].back()["besideAsGiven"] = {{"error", asJson(p.paired->error)},
                                                      {"seconds", asJson(p.paired->seconds)},
                                                      {"efficiency", asJson(p.paired->efficiency)},
                                                      {"efficiencyVerdict", nameOf(efficiencyVerdict(findings, p))},
                                                      {"chanceOfEfficiency", p.paired->chanceOfEfficiency},
                                                      {"energy", asJson(p.paired->energy)},
                                                      {"chanceOfEnergy", p.paired->chanceOfEnergy}};
    }
    json["failures"] = Json::array();
    for (const Point& p : state.points)
        if (!p.failure.empty()) json["failures"].push_back({{"setting", state.settings[p.setting].name()}, {"reason", p.failure}});
    return jsonText(json, 2) + "\n";
}

}  // namespace eikonal
