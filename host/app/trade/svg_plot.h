#pragma once
// Plots curves on logarithmic axes as SVG.

#include <string>
#include <vector>

namespace eikonal {

struct PlotPoint {
    double x = 0, y = 0, low = 0, high = 0;
    std::string title;
};  ///< low, high: an error bar in y, if high > low
struct PlotCurve {
    std::string name, color;
    std::vector<PlotPoint> points;
    bool isBold = false;
};

struct Plot {
    std::string xLabel, yLabel;
    std::vector<PlotCurve> curves;
    std::vector<PlotPoint> front;   ///< a dashed staircase, by ascending x
    int width = 860, height = 480;  ///< of the drawing, in its own units
};

/// An <svg> element. Points that are not positive and finite are left out. Colours other than those of curves are those of the page
/// (currentColor).
std::string asSvg(const Plot& plot);

/// `text` with the characters escaped that mean something in HTML and XML.
std::string escaped(const std::string& text);

}  // namespace eikonal
