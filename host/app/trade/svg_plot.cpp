#include "app/trade/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

constexpr double left = 70, right = 14, top = 12, bottom = 46;

bool isShown(const PlotPoint& p) { return p.x > 0 && p.y > 0 && std::isfinite(p.x) && std::isfinite(p.y); }

/// A logarithmic axis from `from` to `to` in drawing units.
struct Axis {
    double low = 1e300, high = 0, from, to;
    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    void widen() {
        if (high == 0) low = high = 1;
        low /= 1.15;
        high *= 1.15;
    }
    double at(double value) const { return from + (std::log(value) - std::log(low)) / (std::log(high) - std::log(low)) * (to - from); }
    /// 1, 2 and 5 times powers of ten; only those powers if there are many.
    std::vector<double> ticks() const {
        std::vector<double> all;
        const bool isWide = std::log10(high / low) > 3;
        for (double power = std::pow(10, std::floor(std::log10(low))); power <= high; power *= 10)
            for (double factor : {1., 2., 5.})
                if (factor * power >= low && factor * power <= high && (factor == 1 || !isWide)) all.push_back(factor * power);
        return all;
    }
};

std::string drawGrid(const Plot& plot, const Axis& x, const Axis& y) {
    std::string svg = "<g class=\"grid\" stroke=\"currentColor\" stroke-opacity=\".15\">";
    for (double t : x.ticks()) svg += fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}\"/>", x.at(t), y.from, y.to);
    for (double t : y.ticks()) svg += fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\"/>", x.from, y.at(t), x.to);
    svg += "</g><g fill=\"currentColor\" font-size=\"12\">";
    for (double t : x.ticks())
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:g}</text>", x.at(t), y.from + 16, t);
    for (double t : y.ticks())
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:g}</text>", x.from - 6, y.at(t) + 4, t);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", (x.from + x.to) / 2, plot.height - 8.,
                       escaped(plot.xLabel));
    return svg + fmt::format("<text transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text></g>",
                             (y.from + y.to) / 2, escaped(plot.yLabel));
}

std::string drawCurve(const PlotCurve& curve, const Axis& x, const Axis& y) {
    std::string path, marks;
    const double radius = curve.isBold ? 5 : 3.5;
    for (const PlotPoint& p : curve.points) {
        if (!isShown(p)) continue;
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x.at(p.x), y.at(p.y));
        if (p.high > p.low && p.high > 0)
            marks += fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}\" stroke-width=\"1\"/>", x.at(p.x), y.at(std::max(p.low, y.low)),
                                 y.at(std::min(p.high, y.high)));
        marks += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"><title>{}</title></circle>", x.at(p.x), y.at(p.y),
                             radius, curve.color, escaped(p.title));
    }
    return fmt::format("<g stroke=\"{}\" fill=\"none\" stroke-width=\"{}\"><path d=\"{}\"/>{}</g>", curve.color, curve.isBold ? 3 : 1.5,
                       path, marks);
}

}  // namespace

std::string escaped(const std::string& text) {
    std::string all;
    for (char c : text) {
        if (c == '&') all += "&amp;";
        else if (c == '<') all += "&lt;";
        else if (c == '>') all += "&gt;";
        else if (c == '"') all += "&quot;";
        else if (c == '\'') all += "&#39;";
        else all += c;
    }
    return all;
}

std::string asSvg(const Plot& plot) {
    Axis x{.from = left, .to = plot.width - right}, y{.from = plot.height - bottom, .to = top};
    for (const PlotCurve& curve : plot.curves)
        for (const PlotPoint& p : curve.points)
            if (isShown(p)) {
                x.include(p.x);
                y.include(p.y);
            }
    x.widen();
    y.widen();
    std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{} against {}\">", plot.width, plot.height,
                                  escaped(plot.yLabel), escaped(plot.xLabel));
    svg += drawGrid(plot, x, y);
    std::string front;
    for (const PlotPoint& p : plot.front)
        if (isShown(p))
            front +=
                front.empty() ? fmt::format("M{:.1f} {:.1f}", x.at(p.x), y.at(p.y)) : fmt::format("H{:.1f}V{:.1f}", x.at(p.x), y.at(p.y));
    svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"currentColor\" stroke-dasharray=\"6 4\" stroke-opacity=\".6\"/>", front);
    for (const PlotCurve& curve : plot.curves)
        if (!curve.isBold) svg += drawCurve(curve, x, y);
    for (const PlotCurve& curve : plot.curves)
        if (curve.isBold) svg += drawCurve(curve, x, y);
    return svg + "</svg>";
}

}  // namespace eikonal
