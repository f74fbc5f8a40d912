#include "pack/environment_guide.h"

#include "pack/guide_map.h"
#include "pack/guide_openings.h"
#include "pack/guide_place.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace eikonal {
namespace {

constexpr size_t intervals = GUIDE_INTERVALS, openings = GUIDE_OPENINGS, cells = intervals * intervals * intervals;

/// Points per map, and the shadow rays per map with the fewest points: a surface sees about half of the openings.
constexpr size_t fewestPoints = 4, mostPoints = 16, raysAMap = fewestPoints * openings / 2;
/// Fewer maps do not pay.
constexpr size_t fewestMaps = 1024;
/// So many rays tell whether a scene is open, to about half a percent. To find the openings takes a share of all rays.
constexpr size_t fewRays = 8192;
constexpr double shareForOpenings = 0.2;

/// What to assume of rays that were not traced: this fraction of them is not blocked.
constexpr double doubt = 0.002;

/// Weights for a map of what it was found to receive through each opening (pairs of SurveyRays::weigh). To choose an opening in proportion
/// to the root of the mean square of its samples is best: a fraction v of them is not blocked, so that is what arrives over sqrt(v).
std::vector<double> weightsOf(std::span<const double> pairs) {
    std::vector<double> weights;
    for (size_t i = 0; i < openings; ++i) {
        const double seen = pairs[2 * i], possible = pairs[2 * i + 1];
        weights.push_back(std::sqrt((seen + doubt * possible) * possible));
    }
    return weights;
}
double seenBy(std::span<const double> pairs) {
    double seen = 0;
    for (size_t i = 0; i < openings; ++i) seen += pairs[2 * i];
    return seen;
}

std::span<uint> wordsOf(LightTables& tables, size_t map) {
    return std::span(tables.guide_sums).subspan(map * GUIDE_MAP_WORDS, GUIDE_MAP_WORDS);
}

void writeMap(LightTables& tables, size_t map, std::span<const double> weights) {
    writeGuideMap(wordsOf(tables, map), weights);
}

/// Where no light is visible, every density is zero: light samples would be wasted. BSDF samples find what the survey missed.
void writeDarkMap(LightTables& tables, size_t map) {
    writeDarkGuideMap(wordsOf(tables, map));
}

/// Weights for places without a map: the rays that left through each opening.
std::vector<double> exitsOf(const LightTables& tables, std::span<const uint> exits) {
    std::vector<double> weights(openings, 0.0);
    for (const uint texel : exits)
        if (texel < GUIDE_BOX_TEXELS && tables.guide_texels[texel] != NONE) weights[tables.guide_texels[texel]] += 1;
    return weights;
}

/// As kernels/light/guide_place.clh on the device.
size_t intervalOf(std::span<const float> edges, size_t axis, float x) {
    size_t interval = 0;
    for (size_t e = 0; e < intervals - 1; ++e) interval += x >= edges[axis * intervals + e];
    return interval;
}
size_t cellOf(std::span<const float> edges, const vec3& p) {
    return (intervalOf(edges, 2, p.z) * intervals + intervalOf(edges, 1, p.y)) * intervals + intervalOf(edges, 0, p.x);
}

/// Sets the ends of the intervals along an axis so that all hold the same number of points.
void cutAxis(std::span<float> edges, size_t axis, std::span<const vec3> points) {
    std::vector<float> along;
    for (const vec3& p : points) along.push_back(coordinate(p, axis));
    auto rest = along.begin();
    for (size_t e = 0; e < intervals - 1; ++e) {
        const auto end = along.begin() + static_cast<std::ptrdiff_t>((e + 1) * along.size() / intervals);
        std::nth_element(rest, end, along.end());
        edges[axis * intervals + e] = *end;
        rest = end;
    }
}

/// The points of one face of a cell, by index.
struct Group { size_t place; std::vector<size_t> members; };

std::vector<Group> groupPoints(std::span<const float> edges, std::span<const vec3> points, std::span<const vec3> normals,
                               bool hasAllDirections) {
    std::vector<std::vector<size_t>> members(cells * GUIDE_FACES);
    for (size_t i = 0; i < points.size(); ++i) {
        const size_t cell = cellOf(edges, points[i]);
        members[guideFace(normals[i]) * cells + cell].push_back(i);
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
constexpr double neighborShare = 0.3;

/// Adds to what each group sees a part of what the same faces of neighbouring cells see.
std::vector<std::vector<double>> shareWithNeighbors(const std::vector<Group>& groups, std::span<const float> weights) {
    constexpr size_t pairs = 2 * openings;
    std::vector<int> groupAt(cells * GUIDE_FACES, -1);
    for (size_t i = 0; i < groups.size(); ++i) groupAt[groups[i].place] = static_cast<int>(i);
    std::vector<std::vector<double>> shared(groups.size());
    tbb::parallel_for(size_t{0}, groups.size(), [&](size_t i) {
        std::vector<double>& sum = shared[i];
        sum.assign(weights.begin() + static_cast<long>(i * pairs), weights.begin() + static_cast<long>((i + 1) * pairs));
        const size_t place = groups[i].place, cell = place % cells,
                     at[3] = {cell % intervals, cell / intervals % intervals, cell / intervals / intervals};
        size_t stride = 1;
        for (size_t axis = 0; axis < 3; ++axis, stride *= intervals)
            for (const int step : {-1, 1}) {
                if (step < 0 ? at[axis] == 0 : at[axis] == intervals - 1) continue;
                const int neighbor = groupAt[step < 0 ? place - stride : place + stride];
                if (neighbor < 0) continue;
                for (size_t b = 0; b < pairs; ++b) sum[b] += neighborShare * weights[static_cast<size_t>(neighbor) * pairs + b];
            }
    });
    return shared;
}

}  // namespace

void packUnlearnedGuide(LightTables& tables) {
    tables.guide_edges.assign(3 * intervals, FAR_AWAY);
    tables.guide_maps.assign(cells * GUIDE_FACES, 0);
    tables.guide_sums.resize(GUIDE_MAP_WORDS);
    writeDarkMap(tables, 0);
    tables.guide_box = {{0, 0, 0}, {1, 1, 1}};
    packNoGuideOpenings(tables);
}

bool GuideBudget::isEnough() const { return rays / raysAMap >= fewestMaps; }

GuideBudget GuideBudget::of(uint width, uint height, int samples) {
    const double all = static_cast<double>(width) * height * samples;
    return {static_cast<size_t>(std::min(all / 64, 0x1p16)), static_cast<size_t>(std::min(all * 0.4, 0x1p23))};
}

double learnGuide(LightTables& tables, std::span<const vec3> points, std::span<const vec3> normals, const GuideOptions& options,
                  const SurveyRays& survey) {
    packUnlearnedGuide(tables);
    if (points.empty()) return 1;
    packGuideBox(tables, points);
    const auto shareOf = [](std::span<const uint> exits) {
        const auto blocked = static_cast<double>(std::ranges::count(exits, NONE));
        return 1 - blocked / static_cast<double>(exits.size());
    };
    if (options.openShare < 1) {
        const double share = shareOf(survey.exits(tables, std::min(fewRays, options.rays)));
        if (share > 1.1 * options.openShare) return share;
    }

    /* Where the light enters */
    const auto exitRays = static_cast<size_t>(shareForOpenings * static_cast<double>(options.rays));
    const std::vector<uint> exits = survey.exits(tables, exitRays);
    const double share = shareOf(exits);
    if (share == 0) return 0;
    packGuideOpenings(tables, exits);
    writeMap(tables, 0, exitsOf(tables, exits));

    /* How much of it each place receives */
    tbb::parallel_for(size_t{0}, size_t{3}, [&](size_t axis) { cutAxis(tables.guide_edges, axis, points); });
    std::vector<Group> groups = groupPoints(tables.guide_edges, points, normals, options.hasAllDirections);
    std::ranges::stable_sort(groups, std::greater(), [](const Group& g) { return g.members.size(); });
    const size_t rays = options.rays - exitRays;
    groups.resize(std::min(groups.size(), rays / raysAMap));
    const std::vector<float> weights = survey.weigh(
        tables, representativesOf(groups, points, normals, std::clamp(rays / (groups.size() * openings / 2), fewestPoints, mostPoints)));
    const std::vector<std::vector<double>> shared = shareWithNeighbors(groups, weights);
    tables.guide_sums.resize((1 + groups.size()) * GUIDE_MAP_WORDS);
    tbb::parallel_for(size_t{0}, groups.size(), [&](size_t i) {
        const size_t map = 1 + i;
        tables.guide_maps[groups[i].place] = static_cast<uint>(map);
        if (seenBy(shared[i]) > 0) writeMap(tables, map, weightsOf(shared[i]));
        else writeDarkMap(tables, map);
    });
    return share;
}

}  // namespace eikonal
