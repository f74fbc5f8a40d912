#include "pack/environment_guide.h"

#include "pack/alias_table.h"
#include "image/equal_area.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace eikonal {
namespace {

constexpr size_t intervals = GUIDE_INTERVALS, side = GUIDE_SIDE, bins = side * side, cells = intervals * intervals * intervals;

/// Points per map, and the shadow rays per map with the fewest points: a surface sees half of the bins.
constexpr size_t fewestPoints = 4, mostPoints = 16, raysAMap = fewestPoints * bins / 2;
/// Fewer maps do not pay.
constexpr size_t fewestMaps = 1024;
/// So many maps tell whether a scene is open.
constexpr size_t fewMaps = 256;

float coordinate(const vec3& p, size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }
bool isPoint(const vec3& normal) { return normal.x != 0 || normal.y != 0 || normal.z != 0; }

/// The weight of the unlearned map in a learned one, because rays test only parts of each bin.
constexpr double doubt = 0.1;

/// The weights of an unlearned map: the cosine, for normals up to 55 degrees from the axis of the face.
std::vector<double> unlearnedWeights(size_t face) {
    constexpr std::array<glm::dvec3, GUIDE_FACES> axes{glm::dvec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0},
                                                       {0, 0, 1},           {0, 0, -1}, {0, 0, 0}};
    std::vector<double> weights;
    for (size_t bin = 0; bin < bins; ++bin) {
        const glm::dvec3 d =
            directionFromSquare({(static_cast<double>(bin % side) + 0.5) / side, (static_cast<double>(bin / side) + 0.5) / side});
        weights.push_back(face == GUIDE_ALL_DIRECTIONS ? 1 : std::max(glm::dot(d, axes[face]) + 0.5, 0.0));
    }
    return weights;
}

double sumOf(std::span<const double> weights) { return std::accumulate(weights.begin(), weights.end(), 0.0); }

/// The bin at (x, y), wrapped around the edges of the equal-area square (as in kernels/math/equal_area.clh).
size_t wrappedBin(int x, int y) {
    constexpr int n = side;
    if (x < 0 || x >= n) { x = x < 0 ? -1 - x : 2 * n - 1 - x; y = n - 1 - y; }
    if (y < 0 || y >= n) { y = y < 0 ? -1 - y : 2 * n - 1 - y; x = n - 1 - x; }
    return static_cast<size_t>(y * n + x);
}

/// Blurs the bins, since the edge of a window may lie within a bin.
std::vector<double> blur(std::span<const double> seen) {
    std::vector<double> blurred(bins, 0.0);
    for (int y = 0; y < static_cast<int>(side); ++y)
        for (int x = 0; x < static_cast<int>(side); ++x)
            for (int v = -1; v <= 1; ++v)
                for (int u = -1; u <= 1; ++u)
                    blurred[wrappedBin(x + u, y + v)] +=
                        seen[static_cast<size_t>(y) * side + static_cast<size_t>(x)] * (u == 0 && v == 0   ? 1
                                                                                        : u == 0 || v == 0 ? 0.25
                                                                                                           : 0.1);
    return blurred;
}

/// Blends what was seen, which must not be zero, with the unlearned weights.
std::vector<double> blend(std::span<const double> seen, std::span<const double> unlearned) {
    const double all = sumOf(seen), possible = sumOf(unlearned);
    std::vector<double> weights;
    for (size_t i = 0; i < seen.size(); ++i) weights.push_back((1 - doubt) * seen[i] / all + doubt * unlearned[i] / possible);
    return weights;
}

void writeMap(LightTables& tables, size_t map, std::span<const double> weights) {
    std::ranges::copy(makeAliasSquare(weights, side), tables.guide_aliases.begin() + static_cast<long>(map * GUIDE_MAP_ENTRIES));
}

/// Where no light is visible, every density is zero: light samples would be wasted. BSDF samples find what the survey missed.
void writeDarkMap(LightTables& tables, size_t map) {
    std::fill_n(tables.guide_aliases.begin() + static_cast<long>(map * GUIDE_MAP_ENTRIES), GUIDE_MAP_ENTRIES, alias_entry{1, 0, 0});
}

/// As kernels/light/guide_place.clh on the device.
size_t intervalOf(std::span<const float> edges, size_t axis, float x) {
    size_t interval = 0;
    for (size_t e = 0; e < intervals - 1; ++e) interval += x >= edges[axis * intervals + e];
    return interval;
}
size_t faceOf(const vec3& n) {
    const float x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
    return z >= x && z >= y ? (n.z < 0 ? 5 : 4) : x >= y ? (n.x < 0 ? 1 : 0) : (n.y < 0 ? 3 : 2);
}
size_t cellOf(std::span<const float> edges, const vec3& p) {
    return (intervalOf(edges, 2, p.z) * intervals + intervalOf(edges, 1, p.y)) * intervals + intervalOf(edges, 0, p.x);
}

/// Sets the ends of the intervals along an axis so that all hold the same number of points.
void cutAxis(std::span<float> edges, size_t axis, std::span<const vec3> points, std::span<const vec3> normals) {
    std::vector<float> sorted;
    for (size_t i = 0; i < points.size(); ++i)
        if (isPoint(normals[i])) sorted.push_back(coordinate(points[i], axis));
    std::ranges::sort(sorted);
    for (size_t e = 0; e < intervals - 1; ++e) edges[axis * intervals + e] = sorted[(e + 1) * sorted.size() / intervals];
}

/// The points of one face of a cell, by index.
struct Group { size_t place; std::vector<size_t> members; };

std::vector<Group> groupPoints(std::span<const float> edges, std::span<const vec3> points, std::span<const vec3> normals,
                               bool hasAllDirections) {
    std::vector<std::vector<size_t>> members(cells * GUIDE_FACES);
    for (size_t i = 0; i < points.size(); ++i) {
        if (!isPoint(normals[i])) continue;
        const size_t cell = cellOf(edges, points[i]);
        members[faceOf(normals[i]) * cells + cell].push_back(i);
        if (hasAllDirections) members[GUIDE_ALL_DIRECTIONS * cells + cell].push_back(i);
    }
    std::vector<Group> groups;
    for (size_t place = 0; place < members.size(); ++place)
        if (!members[place].empty()) groups.push_back({place, std::move(members[place])});
    return groups;
}

/// Chooses points of each group, evenly spread over its members.
GuideRepresentatives representativesOf(const std::vector<Group>& groups, std::span<const vec3> points, std::span<const vec3> normals,
                                       size_t perMap) {
    GuideRepresentatives r{{}, {}, groups.size(), perMap};
    for (const Group& g : groups)
        for (size_t k = 0; k < perMap; ++k) {
            const size_t i = g.members[(2 * k + 1) * g.members.size() / (2 * perMap)];
            r.points.push_back(points[i]);
            r.normals.push_back(g.place / cells == GUIDE_ALL_DIRECTIONS ? vec3{0, 0, 0} : normals[i]);
        }
    return r;
}

/// The weight of what neighbouring cells see.
constexpr double neighborShare = 0.1;

/// At most fewMaps groups on surfaces, evenly spread over the list.
std::vector<Group> someOnSurfaces(const std::vector<Group>& groups) {
    const auto isOnSurface = [](const Group& g) { return g.place / cells != GUIDE_ALL_DIRECTIONS; };
    const size_t all = static_cast<size_t>(std::ranges::count_if(groups, isOnSurface)), step = (all + fewMaps - 1) / fewMaps;
    std::vector<Group> some;
    size_t number = 0;
    for (const Group& g : groups)
        if (isOnSurface(g) && number++ % step == 0) some.push_back(g);
    return some;
}

/// The fraction of an environment's light that reaches the groups. The mean of the cosine over all directions is 1/4.
double shareOf(const std::vector<Group>& groups, std::span<const float> weights, size_t perMap) {
    double seen = 0, possible = 0;
    for (size_t i = 0; i < groups.size(); ++i) {
        if (groups[i].place / cells == GUIDE_ALL_DIRECTIONS) continue;
        const double members = static_cast<double>(groups[i].members.size());
        seen += members *
                std::accumulate(weights.begin() + static_cast<long>(i * bins), weights.begin() + static_cast<long>((i + 1) * bins), 0.0);
        possible += members * static_cast<double>(perMap * bins) / 4;
    }
    return possible > 0 ? std::min(seen / possible, 1.0) : 1;
}

/// Adds to what each group sees a part of what the same faces of neighbouring cells see.
std::vector<std::vector<double>> shareWithNeighbors(const std::vector<Group>& groups, std::span<const float> weights) {
    std::vector<int> groupAt(cells * GUIDE_FACES, -1);
    for (size_t i = 0; i < groups.size(); ++i) groupAt[groups[i].place] = static_cast<int>(i);
    std::vector<std::vector<double>> shared(groups.size());
    tbb::parallel_for(size_t{0}, groups.size(), [&](size_t i) {
        std::vector<double>& sum = shared[i];
        sum.assign(weights.begin() + static_cast<long>(i * bins), weights.begin() + static_cast<long>((i + 1) * bins));
        const size_t place = groups[i].place, cell = place % cells,
                     at[3] = {cell % intervals, cell / intervals % intervals, cell / intervals / intervals};
        size_t stride = 1;
        for (size_t axis = 0; axis < 3; ++axis, stride *= intervals)
            for (const int step : {-1, 1}) {
                if (step < 0 ? at[axis] == 0 : at[axis] == intervals - 1) continue;
                const int neighbor = groupAt[step < 0 ? place - stride : place + stride];
                if (neighbor < 0) continue;
                for (size_t b = 0; b < bins; ++b) sum[b] += neighborShare * weights[static_cast<size_t>(neighbor) * bins + b];
            }
    });
    return shared;
}

}  // namespace

void packUnlearnedGuide(LightTables& tables) {
    tables.guide_edges.assign(3 * intervals, FAR_AWAY);
    tables.guide_maps.resize(cells * GUIDE_FACES);
    for (size_t i = 0; i < tables.guide_maps.size(); ++i) tables.guide_maps[i] = static_cast<uint>(i / cells);
    tables.guide_aliases.resize(GUIDE_FACES * GUIDE_MAP_ENTRIES);
    for (size_t face = 0; face < GUIDE_FACES; ++face) writeMap(tables, face, unlearnedWeights(face));
}

bool GuideBudget::isEnough() const { return rays / raysAMap >= fewestMaps; }

GuideBudget GuideBudget::of(uint width, uint height, int samples) {
    const double all = static_cast<double>(width) * height * samples;
    return {static_cast<size_t>(std::min(all / 64, 0x1p16)), static_cast<size_t>(std::min(all * 0.4, 0x1p23))};
}

double learnGuide(LightTables& tables, std::span<const vec3> points, std::span<const vec3> normals, const GuideOptions& options,
                  const WeighMaps& weigh) {
    packUnlearnedGuide(tables);
    if (std::ranges::none_of(normals, isPoint)) return 1;
    for (size_t axis = 0; axis < 3; ++axis) cutAxis(tables.guide_edges, axis, points, normals);
    std::vector<Group> groups = groupPoints(tables.guide_edges, points, normals, options.hasAllDirections);
    std::ranges::stable_sort(groups, std::greater(), [](const Group& g) { return g.members.size(); });
    size_t rays = options.rays;
    if (const std::vector<Group> few = someOnSurfaces(groups); options.openShare < 1 && !few.empty()) {
        const double share = shareOf(few, weigh(representativesOf(few, points, normals, fewestPoints)), fewestPoints);
        rays -= std::min(rays, few.size() * raysAMap);
        if (share > 1.5 * options.openShare) {
            packUnlearnedGuide(tables);
            return share;
        }
    }
    groups.resize(std::min(groups.size(), rays / raysAMap));

    const GuideRepresentatives representatives =
        representativesOf(groups, points, normals, std::clamp<size_t>(rays / (groups.size() * bins / 2), fewestPoints, mostPoints));
    const std::vector<float> weights = weigh(representatives);
    const std::vector<std::vector<double>> shared = shareWithNeighbors(groups, weights);
    std::array<std::vector<double>, GUIDE_FACES> unlearned;
    for (size_t face = 0; face < GUIDE_FACES; ++face) unlearned[face] = unlearnedWeights(face);
    tables.guide_aliases.resize((GUIDE_FACES + groups.size()) * GUIDE_MAP_ENTRIES);
    tbb::parallel_for(size_t{0}, groups.size(), [&](size_t i) {
        const size_t map = GUIDE_FACES + i;
        tables.guide_maps[groups[i].place] = static_cast<uint>(map);
        if (sumOf(shared[i]) > 0) writeMap(tables, map, blend(blur(shared[i]), unlearned[groups[i].place / cells]));
        else writeDarkMap(tables, map);
    });

    return shareOf(groups, weights, representatives.perMap);
}

}  // namespace eikonal
