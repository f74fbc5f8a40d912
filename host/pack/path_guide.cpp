#include "pack/path_guide.h"

#include "image/equal_area.h"
#include "pack/alias_table.h"
#include "pack/guide_place.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace eikonal {
namespace {

constexpr size_t side = PATH_GUIDE_SIDE, texels = side * side, entries = PATH_GUIDE_ENTRIES;

/// A leaf is cut in two while each part has this many records with light; one with fewer than a quarter of that has no map.
constexpr size_t leastLit = 128;
/// Records that are brighter than this times the mean of their leaf count as that bright: one path must not decide a map.
constexpr double mostOfMean = 50;
/// The share of a map that is spread over all directions.
constexpr double evenShare = 0.02;

struct Leaf { size_t node, begin, end; };

/// Cuts the records of one face.
class Tree {
public:
    Tree(std::span<const GuideRecord> records, Table<path_guide_node>& nodes) : records_(records), nodes_(nodes) {}
    void cut(size_t node, std::span<uint> members, size_t first, int depth) {
        size_t lit = 0;
        std::array<float, 3> low{FAR_AWAY, FAR_AWAY, FAR_AWAY}, high{-FAR_AWAY, -FAR_AWAY, -FAR_AWAY};
        for (const uint i : members) {
            lit += records_[i].light > 0;
            for (size_t a = 0; a < 3; ++a) {
                low[a] = std::min(low[a], coordinate(records_[i].p, a));
                high[a] = std::max(high[a], coordinate(records_[i].p, a));
            }
        }
        size_t axis = 0;
        for (size_t a = 1; a < 3; ++a)
            if (high[a] - low[a] > high[axis] - low[axis]) axis = a;
        if (lit < 2 * leastLit || depth + 1 >= PATH_GUIDE_DEPTH || !(high[axis] > low[axis])) {
            if (lit >= leastLit / 4) leaves.push_back({node, first, first + members.size()});
            return;
        }
        /* At the median of those with light */
        std::vector<float> at;
        for (const uint i : members)
            if (records_[i].light > 0) at.push_back(coordinate(records_[i].p, axis));
        std::ranges::nth_element(at, at.begin() + static_cast<long>(at.size() / 2));
        const float middle = at[at.size() / 2];
        const auto above = std::ranges::stable_partition(members, [&](uint i) { return coordinate(records_[i].p, axis) < middle; });
        const size_t below = members.size() - above.size();
        if (below == 0 || below == members.size()) {
            leaves.push_back({node, first, first + members.size()});
            return;
        }
        const size_t next = nodes_.size();
        nodes_.resize(next + 2, path_guide_node{0, PATH_GUIDE_LEAF, 0});
        nodes_[node] = {middle, static_cast<uint>(axis), static_cast<uint>(next)};
        cut(next, members.first(below), first, depth + 1);
        cut(next + 1, members.subspan(below), first + below, depth + 1);
    }
    std::vector<Leaf> leaves;

private:
    std::span<const GuideRecord> records_;
    Table<path_guide_node>& nodes_;
};

/// The light that arrives from each texel, by the records of a leaf, blurred by a texel.
std::vector<double> weightsOf(std::span<const GuideRecord> records, std::span<const uint> members) {
    constexpr int n = PATH_GUIDE_SIDE;
    std::vector<double> found(texels, 0.0), light;
    for (const uint i : members) {
        const GuideRecord& r = records[i];
        const double cosine = std::abs(double{r.d.x} * r.n.x + double{r.d.y} * r.n.y + double{r.d.z} * r.n.z);
        light.push_back(r.light * cosine / r.pdf);
    }
    const double most = mostOfMean * std::accumulate(light.begin(), light.end(), 0.0) / static_cast<double>(members.size());
    for (size_t k = 0; k < members.size(); ++k) {
        const vec3& d = records[members[k]].d;
        const glm::dvec2 at = squareFromDirection({d.x, d.y, d.z});
        const auto texelOf = [](double u) { return std::min(static_cast<int>(u * n), n - 1); };
        const int x = texelOf(at.x), y = texelOf(at.y);
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const glm::ivec2 texel = wrapTexelOfSquare({x + dx, y + dy}, n);
                found[static_cast<size_t>(texel.y * n + texel.x)] += std::min(light[k], most) * (dx ? 0.25 : 0.5) * (dy ? 0.25 : 0.5);
            }
    }
    const double sum = std::accumulate(found.begin(), found.end(), 0.0);
    for (double& f : found) f += evenShare * sum / texels;
    return found;
}

}  // namespace

void packUnlearnedPathGuide(LightTables& tables) {
    tables.path_guide_nodes.assign(GUIDE_FACES, path_guide_node{0, PATH_GUIDE_LEAF, 0});
    tables.path_guide_aliases = makeAliasSquare(std::vector<double>(texels, 1.0), side);
}

double pdfOfGuide(const LightTables& tables, uint map, const vec3& d) {
    const glm::dvec2 at = squareFromDirection({d.x, d.y, d.z});
    const auto texelOf = [](double u) { return static_cast<size_t>(std::clamp(static_cast<int>(u * side), 0, PATH_GUIDE_SIDE - 1)); };
    const alias_entry* const square = &tables.path_guide_aliases[map * entries];
    const size_t row = texelOf(at.y);
    const double pmf = double{square[row].pmf} * double{square[side + row * side + texelOf(at.x)].pmf};
    return pmf * texels / (4 * M_PI);
}

size_t learnPathGuide(LightTables& tables, std::span<const GuideRecord> records, bool hasAllDirections) {
    packUnlearnedPathGuide(tables);
    std::array<std::vector<uint>, GUIDE_FACES> members;
    for (size_t i = 0; i < records.size(); ++i) {
        members[guideFace(records[i].n)].push_back(static_cast<uint>(i));
        if (hasAllDirections) members[GUIDE_ALL_DIRECTIONS].push_back(static_cast<uint>(i));
    }
    size_t maps = 0;
    for (size_t face = 0; face < GUIDE_FACES; ++face) {
        Tree tree(records, tables.path_guide_nodes);
        tree.cut(face, members[face], 0, 0);
        const size_t first = 1 + maps;
        maps += tree.leaves.size();
        tables.path_guide_aliases.resize((1 + maps) * entries);
        tbb::parallel_for(size_t{0}, tree.leaves.size(), [&](size_t k) {
            const Leaf& leaf = tree.leaves[k];
            const std::vector<double> weights =
                weightsOf(records, std::span(members[face]).subspan(leaf.begin, leaf.end - leaf.begin));
            if (!(std::accumulate(weights.begin(), weights.end(), 0.0) > 0)) return;
            tables.path_guide_nodes[leaf.node].next = static_cast<uint>(first + k);
            fillAliasSquare(std::span(tables.path_guide_aliases).subspan((first + k) * entries, entries), weights, side);
        });
    }
    return maps;
}

}  // namespace eikonal
