#include "bvh/subtree.h"

#include "bvh/split.h"

#include <algorithm>
#include <array>
#include <limits>

namespace eikonal {

/// Cost of a visit in units of testing a node's eight boxes, as measured (docs/performance.md).
constexpr float nodeCost = 1, blockCost = 1, elementCost = 1, instanceCost = 4;
/// Below this many splits ranges are split in halves, which bounds the recursion.
constexpr int deepest = 64;

/// Ranges of so few triangles are not split: smaller leaves do not lower the expected cost (docs/performance.md).
constexpr uint unsplitTriangles = 3;

/// A node of the binary tree over references. Parents come before their children.
struct BinaryNode {
    Range range;
    uint left = 0, right = 0;                  ///< 0: not split
    /// cost[i]: lowest cost of its references as at most i children of a wide node (1 <= i <= 7).
    std::array<float, BVH_WIDTH> cost;
    /// share[i]: how many of i children go to the left subtree (0: same as for i - 1; for i = 1: a leaf, or a node if not 0).
    std::array<std::uint8_t, BVH_WIDTH + 1> share;
};

class SubtreeBuilder {
public:
    /// nodes: memory for the binary tree, reused between calls.
    SubtreeBuilder(const Sources& sources, std::span<Reference> references, std::vector<BinaryNode>& nodes)
        : sources_(sources), references_(references), nodes_(nodes) {}

    Subtree build(const Range& range, int maxDepth, bool alwaysNode) {
        nodes_.clear();
        nodes_.reserve(2 * size_t(range.size()));
        grow(range, false);
        for (size_t i = nodes_.size(); i-- > 0;) weigh(nodes_[i]);
        if (emit(alwaysNode).depth > maxDepth) {
            nodes_.clear();
            grow(range, true);
            for (size_t i = nodes_.size(); i-- > 0;) weighEvenly(nodes_[i]);
            emit(alwaysNode);
        }
        return std::move(result_);
    }

private:
    uint grow(const Range& range, bool halves, int depth = 0) {
        const uint at = static_cast<uint>(nodes_.size());
        nodes_.emplace_back().range = range;
        if (range.size() == 1 || (range.size() <= unsplitTriangles && range.holdsOnly(leaf_triangles))) return at;
        const auto [left, right] = halves || depth > deepest ? splitInHalves(references_, range) : splitByCost(references_, range);
        const uint l = grow(left, halves, depth + 1), r = grow(right, halves, depth + 1);
        nodes_[at].left = l;
        nodes_[at].right = r;
        return at;
    }

    float leafCost(const Range& range) const {
        if (!range.fitsLeaf()) return std::numeric_limits<float>::max();
        if (range.holdsOnly(leaf_triangles)) return blockCost;
        return range.holdsOnly(leaf_instances) ? instanceCost : elementCost * static_cast<float>(range.size());
    }

    /* The lowest cost as at most i children, from those of both subtrees */
    void weigh(BinaryNode& n) const {
        const float area = n.range.box.halfArea(), asLeaf = leafCost(n.range);
        n.share.fill(0);
        if (n.left == 0) { n.cost.fill(area * asLeaf); return; }
        const BinaryNode &l = nodes_[n.left], &r = nodes_[n.right];
        float least = 0;
        for (int i = 2; i <= BVH_WIDTH; ++i) {
            for (int k = std::max(1, i - 7); k <= std::min(7, i - 1); ++k) {
                if (n.share[i] != 0 && !(l.cost[k] + r.cost[i - k] < least)) continue;
                least = l.cost[k] + r.cost[i - k];
                n.share[i] = static_cast<std::uint8_t>(k);
            }
            if (i < BVH_WIDTH) n.cost[i] = least;
        }
        const float asNode = area * nodeCost + least;
        n.share[1] = n.range.fitsLeaf() && area * asLeaf <= asNode ? 0 : 1;
        n.cost[1] = n.share[1] ? asNode : area * asLeaf;
        for (int i = 2; i < BVH_WIDTH; ++i) {
            if (n.cost[i] < n.cost[i - 1]) continue;
            n.cost[i] = n.cost[i - 1];
            n.share[i] = 0;
        }
    }

    /* Collapses three levels of the binary tree into each node, for the least depth */
    void weighEvenly(BinaryNode& n) const {
        n.share = {0, 1, 1, 0, 2, 0, 0, 0, 4};
        if (n.range.fitsLeaf()) n.share.fill(0);
    }

    Subtree& emit(bool alwaysNode) {
        result_ = {};
        result_.tables.triangleLines.reserve(nodes_[0].range.size());
        if (nodes_[0].share[1] == 0 && !alwaysNode) result_.root = emitLeaf(nodes_[0]);
        else result_.root = emitNode(nodes_[0], 1);
        return result_;
    }

    uint emitLeaf(const BinaryNode& n) {
        ++result_.leaves;
        result_.cost += n.range.box.halfArea() * leafCost(n.range);
        return appendLeaf(result_.tables, sources_, references_.subspan(n.range.begin, n.range.size()));
    }

    uint emitNode(const BinaryNode& n, int depth) {
        result_.depth = std::max(result_.depth, depth);
        result_.cost += n.range.box.halfArea() * nodeCost;
        const uint at = static_cast<uint>(result_.tables.nodes.size());
        result_.tables.nodes.push_back(emptyNode());
        std::array<uint, BVH_WIDTH> children;
        int count = 0;
        collect(n, n.share[1] == 0 ? 1 : BVH_WIDTH, children, count);
        for (int lane = 0; lane < count; ++lane) {
            const BinaryNode& child = nodes_[children[lane]];
            const uint reference = child.share[1] == 0 ? emitLeaf(child) : emitNode(child, depth + 1);
            setChild(result_.tables.nodes[at], lane, child.range.box, reference);
        }
        return at;
    }

    /* Collects the children of a wide node, when n may fill `slots` of it */
    void collect(const BinaryNode& n, int slots, std::array<uint, BVH_WIDTH>& children, int& count) const {
        while (slots > 1 && n.share[slots] == 0) --slots;
        if (slots == 1) { children[count++] = static_cast<uint>(&n - nodes_.data()); return; }
        collect(nodes_[n.left], n.share[slots], children, count);
        collect(nodes_[n.right], slots - n.share[slots], children, count);
    }

    const Sources& sources_;
    std::span<Reference> references_;
    std::vector<BinaryNode>& nodes_;
    Subtree result_;
};

int balancedDepth(uint count) { return std::max(1, (static_cast<int>(std::bit_width(count - 1)) + 2) / 3); }

Subtree buildSubtree(const Sources& sources, std::span<Reference> references, const Range& range, int maxDepth, bool alwaysNode) {
    /* Reused, since each subtree would otherwise allocate a megabyte */
    static thread_local std::vector<BinaryNode> nodes;
    return SubtreeBuilder(sources, references, nodes).build(range, maxDepth, alwaysNode);
}

}  // namespace eikonal
