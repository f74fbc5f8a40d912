#include "pack/guide_openings.h"

#include "pack/space.h"

#include <algorithm>
#include <array>
#include <limits>

namespace eikonal {
namespace {

constexpr int texels = GUIDE_TEXELS;

/// Of all points, the share below, and above, the box along each axis: a room's windows show places outside that paths reach.
constexpr double shareOutside = 0.01;

/// Texels x0 <= x < x1, y0 <= y < y1 of a side of the box, and how many rays leave through them.
struct Part {
    int side, x0, y0, x1, y1;
    double rays;
    int area() const { return (x1 - x0) * (y1 - y0); }
};

/// The number of a texel of the box.
size_t texelAt(int side, int x, int y) { return static_cast<size_t>((side * texels + y) * texels + x); }

/// The rays of each texel of the box.
class ExitCounts {
public:
    /// size: of the box.
    ExitCounts(std::span<const uint> exits, glm::dvec3 size)
        : counts_(GUIDE_BOX_TEXELS, 0.0), texelAreas_{size.y * size.z, size.x * size.z, size.x * size.y} {
        for (const uint texel : exits)
            if (texel < GUIDE_BOX_TEXELS) counts_[texel] += 1;
        spread();
    }
    double at(int side, int x, int y) const { return counts_[texelAt(side, x, y)]; }

    /// Rays times area: the noise of samples that are uniform over a part.
    double costOf(const Part& p) const { return p.rays * p.area() * texelAreas_[static_cast<size_t>(p.side / 2)]; }

    /// The smallest part with the same rays.
    Part shrunk(Part p) const {
        Part small{p.side, p.x1, p.y1, p.x0, p.y0, 0};
        for (int y = p.y0; y < p.y1; ++y)
            for (int x = p.x0; x < p.x1; ++x) {
                const double rays = at(p.side, x, y);
                if (rays == 0) continue;
                small = {p.side, std::min(small.x0, x), std::min(small.y0, y), std::max(small.x1, x + 1), std::max(small.y1, y + 1),
                         small.rays + rays};
            }
        return small;
    }

private:
    /// Texels around one with rays are likely to have some, too.
    void spread() {
        constexpr double share = 0.05;
        const std::vector<double> own = counts_;
        for (int side = 0; side < 6; ++side)
            for (int y = 0; y < texels; ++y)
                for (int x = 0; x < texels; ++x)
                    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, texels - 1); ++v)
                        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, texels - 1); ++u)
                            counts_[texelAt(side, u, v)] += share * own[texelAt(side, x, y)];
    }
    std::vector<double> counts_;
    std::array<double, 3> texelAreas_;   ///< by axis, in one unit
};

/// The two parts, each as small as its rays allow, with the least cost; the same part twice if there is nothing to split.
std::array<Part, 2> split(const ExitCounts& counts, const Part& p) {
    std::array<Part, 2> best{p, p};
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&](Part low, Part high) {
        low = counts.shrunk(low);
        high = counts.shrunk(high);
        const double cost = counts.costOf(low) + counts.costOf(high);
        if (low.rays > 0 && high.rays > 0 && cost < least) {
            least = cost;
            best = {low, high};
        }
    };
    for (int x = p.x0 + 1; x < p.x1; ++x) consider({p.side, p.x0, p.y0, x, p.y1, 0}, {p.side, x, p.y0, p.x1, p.y1, 0});
    for (int y = p.y0 + 1; y < p.y1; ++y) consider({p.side, p.x0, p.y0, p.x1, y, 0}, {p.side, p.x0, y, p.x1, p.y1, 0});
    return best;
}

/// The rectangle of a part on a box with this low corner and size.
guide_opening openingOf(const Part& p, glm::dvec3 low, glm::dvec3 size) {
    const int axis = p.side / 2, across = axis == 0 ? 1 : 0, up = axis == 2 ? 1 : 2;
    glm::dvec3 corner = low, a{0}, b{0}, n{0};
    if (p.side % 2) corner[axis] += size[axis];
    n[axis] = p.side % 2 ? 1 : -1;
    const double width = size[across] / texels, height = size[up] / texels;
    corner[across] += p.x0 * width;
    corner[up] += p.y0 * height;
    a[across] = (p.x1 - p.x0) * width;
    b[up] = (p.y1 - p.y0) * height;
    return {toVec3(corner), toVec3(a), toVec3(b), toVec3(n), static_cast<float>(1 / (a[across] * b[up]))};
}

}  // namespace

void packGuideBox(LightTables& tables, std::span<const vec3> points) {
    Box box;
    constexpr std::array axes{&vec3::x, &vec3::y, &vec3::z};
    for (int i = 0; i < 3; ++i) {
        std::vector<float> along;
        for (const vec3& p : points) along.push_back(p.*axes[static_cast<size_t>(i)]);
        const auto outside = static_cast<long>(shareOutside * static_cast<double>(along.size()));
        std::ranges::nth_element(along, along.begin() + outside);
        box.low[i] = along[static_cast<size_t>(outside)];
        std::ranges::nth_element(along, along.end() - 1 - outside);
        box.high[i] = along[along.size() - 1 - static_cast<size_t>(outside)];
    }
    /* Scene space is of order one: what is closer than this to a side would suffer from rounding */
    const glm::dvec3 pad(0.01 * box.radius() + 1e-4), low = box.low - pad, size = box.high + pad - low;
    tables.guide_box = {toVec3(low), toVec3(size)};
}

void packNoGuideOpenings(LightTables& tables) {
    tables.guide_openings.assign(GUIDE_OPENINGS, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0});
    tables.guide_texels.assign(GUIDE_BOX_TEXELS, NONE);
}

void packGuideOpenings(LightTables& tables, std::span<const uint> exits) {
    packNoGuideOpenings(tables);
    const vec3 low = tables.guide_box[0], size = tables.guide_box[1];
    const ExitCounts counts(exits, {size.x, size.y, size.z});
    std::vector<Part> parts;
    for (int side = 0; side < 6; ++side)
        if (const Part whole = counts.shrunk({side, 0, 0, texels, texels, 0}); whole.rays > 0) parts.push_back(whole);

    /* Split the part with the highest cost; its halves take its place in the list */
    while (!parts.empty() && parts.size() < GUIDE_OPENINGS) {
        const auto worst = std::ranges::max_element(parts, std::less(), [&](const Part& p) { return p.area() > 1 ? counts.costOf(p) : 0; });
        if (worst->area() <= 1) break;
        const std::array<Part, 2> halves = split(counts, *worst);
        *worst = halves[0];
        parts.insert(worst + 1, halves[1]);
    }

    for (size_t i = 0; i < parts.size(); ++i) {
        const Part& p = parts[i];
        tables.guide_openings[i] = openingOf(p, {low.x, low.y, low.z}, {size.x, size.y, size.z});
        for (int y = p.y0; y < p.y1; ++y)
            for (int x = p.x0; x < p.x1; ++x) tables.guide_texels[texelAt(p.side, x, y)] = static_cast<uint>(i);
    }
}

}  // namespace eikonal
