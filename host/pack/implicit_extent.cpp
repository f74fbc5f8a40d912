#include "pack/implicit_extent.h"

#include "pack/implicit_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace eikonal {
namespace {

/// Cells per side are 2^levels: as many as take at most this number of operations if all of them are looked at.
constexpr double mostOperations = 3e7;
constexpr int mostLevels = 6;
/// A mesh of less than this share of the area by cells misses parts of the surface.
constexpr double leastShareOfCells = 0.1;

int levelsFor(size_t operations) {
    int levels = mostLevels;
    while (levels > 2 && std::ldexp(static_cast<double>(operations), 3 * levels) > mostOperations) --levels;
    return levels;
}

/// Adds the cells that the surface may cross, `levels` halvings below this one.
void addCells(std::span<const implicit_instruction> program, const Box& cell, int levels, std::vector<Box>& cells) {
    const std::optional<ValueRange> f = boundsOver(program, cell);
    if (!f || !f->hasZero()) return;
    if (levels == 0) { cells.push_back(cell); return; }
    const glm::dvec3 middle = cell.center();
    for (unsigned i = 0; i < 8; ++i) {
        Box part{middle, middle};
        part.grow(cell.corner(i));
        addCells(program, part, levels - 1, cells);
    }
}

double triangleArea(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) { return 0.5 * glm::length(glm::cross(b - a, c - a)); }

/// A corner of a cell, mapped by m, with the value of F there.
struct Corner { glm::dvec3 p; double f; };
glm::dvec3 crossing(const Corner& a, const Corner& b) { return glm::mix(a.p, b.p, a.f / (a.f - b.f)); }

/// The part of a tetrahedron's linear interpolation that is zero.
double areaInTetrahedron(std::array<Corner, 4> t) {
    const auto middle = std::partition(t.begin(), t.end(), [](const Corner& c) { return c.f < 0; });
    const auto inside = middle - t.begin();
    if (inside == 0 || inside == 4) return 0;
    if (inside == 3) std::reverse(t.begin(), t.end());
    if (inside != 2) return triangleArea(crossing(t[0], t[1]), crossing(t[0], t[2]), crossing(t[0], t[3]));
    const glm::dvec3 a = crossing(t[0], t[2]), b = crossing(t[0], t[3]), c = crossing(t[1], t[3]), d = crossing(t[1], t[2]);
    return triangleArea(a, b, c) + triangleArea(a, c, d);
}

double areaInCell(std::span<const implicit_instruction> program, const Box& cell, const glm::dmat4& m) {
    std::array<Corner, 8> corners;
    for (unsigned i = 0; i < 8; ++i) {
        const glm::dvec3 p = cell.corner(i);
        const std::optional<ValueRange> f = boundsOver(program, {p, p});
        if (!f || !std::isfinite(f->middle())) return 0;
        corners[i] = {transformPoint(m, p), f->middle()};
    }
    /* Six tetrahedra around a diagonal: paths along the three axes from corner 0 to corner 7 */
    static constexpr std::pair<unsigned, unsigned> paths[] = {{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}};
    double area = 0;
    for (const auto& [first, second] : paths) area += areaInTetrahedron({corners[0], corners[first], corners[second], corners[7]});
    return area;
}

}  // namespace

ImplicitExtent extentOf(std::span<const implicit_instruction> program, const Box& box, const glm::dmat4& m) {
    std::vector<Box> cells;
    addCells(program, box, levelsFor(program.size()), cells);
    ImplicitExtent extent;
    if (cells.empty()) return extent;

    /* A sphere around their corners */
    Box around;
    for (const Box& cell : cells) around.grow(transformed(cell, m));
    extent.center = around.center();
    for (const Box& cell : cells)
        for (unsigned i = 0; i < 8; ++i)
            extent.radius = std::max(extent.radius, glm::distance(extent.center, transformPoint(m, cell.corner(i))));

    for (const Box& cell : cells) extent.area += areaInCell(program, cell, m);
    /* A plane crosses (|n.x| + |n.y| + |n.z|) cells per area of a cell's face: 3/2 on average */
    const glm::dvec3 size = cells.front().high - cells.front().low;
    const glm::dvec3 a = transformVector(m, {size.x, 0, 0}), b = transformVector(m, {0, size.y, 0}), c = transformVector(m, {0, 0, size.z});
    const double face = (glm::length(glm::cross(a, b)) + glm::length(glm::cross(b, c)) + glm::length(glm::cross(c, a))) / 3;
    const double byCells = static_cast<double>(cells.size()) * face / 1.5;
    if (extent.area < leastShareOfCells * byCells) extent.area = byCells;
    return extent;
}

}  // namespace eikonal
