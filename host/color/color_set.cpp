#include "color/color_set.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace eikonal {

/// Drops the smallest shares where there are too many, and makes the sum of the rest 1.
static ColorSet limited(ColorSet set) {
    std::ranges::stable_sort(set, std::greater(), &SharedColor::share);
    if (set.size() > mostColors) set.resize(mostColors);
    double sum = 0;
    for (const SharedColor& c : set) sum += c.share;
    for (SharedColor& c : set) c.share /= sum > 0 ? sum : 1;
    return set;
}

ColorSet unite(const ColorSet& a, double shareOfA, const ColorSet& b, double shareOfB) {
    ColorSet both;
    for (const SharedColor& c : a) both.push_back({c.color, c.share * shareOfA});
    for (const SharedColor& c : b) both.push_back({c.color, c.share * shareOfB});
    return limited(std::move(both));
}

ColorSet combine(const ColorSet& a, const ColorSet& b, const std::function<DualColor(const DualColor&, const DualColor&)>& f) {
    ColorSet pairs;
    for (const SharedColor& x : a)
        for (const SharedColor& y : b) pairs.push_back({f(x.color, y.color), x.share * y.share});
    return limited(std::move(pairs));
}

ColorSet map(const ColorSet& set, const std::function<DualColor(const DualColor&)>& f) {
    ColorSet result;
    for (const SharedColor& c : set) result.push_back({f(c.color), c.share});
    return result;
}

DualColor meanOf(const ColorSet& set) {
    DualColor sum;
    for (const SharedColor& c : set) sum = sum + c.color * c.share;
    return sum;
}

ColorSet colorsOf(const std::vector<glm::dvec3>& texels, bool isLight) {
    /* A cell holds texels of similar ratios; of reflectances, also of similar brightness */
    constexpr double cells = 6;
    struct Cell {
        glm::dvec3 sum{0};
        double count = 0;
    };
    std::map<std::tuple<int, int, int>, Cell> grid;
    for (const glm::dvec3& rgb : texels) {
        const double largest = std::max({rgb.x, rgb.y, rgb.z});
        const glm::dvec3 place = glm::sqrt(glm::max(isLight && largest > 0 ? rgb / largest : rgb, 0.0)) * cells;
        Cell& cell =
            grid[{static_cast<int>(std::lround(place.x)), static_cast<int>(std::lround(place.y)), static_cast<int>(std::lround(place.z))}];
        cell.sum += rgb;
        cell.count += 1;
    }
    ColorSet set;
    const auto brightness = [](glm::dvec3 rgb) { return rgb.x + rgb.y + rgb.z; };
    double mean = 0;
    for (const auto& [place, cell] : grid) mean += brightness(cell.sum) / static_cast<double>(texels.size());
    for (const auto& [place, cell] : grid) {
        const double sum = brightness(cell.sum);
        if (!isLight) set.push_back({DualColor::texel(cell.sum / cell.count, true), cell.count});
        else if (sum > 0) set.push_back({DualColor::texel(cell.sum, false) * (mean / sum), sum});
    }
    return limited(std::move(set));
}

}  // namespace eikonal
