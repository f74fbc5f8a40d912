#include "pack/light_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace eikonal {

using std::numbers::pi;

constexpr int buckets = 12;
/// Beyond this depth ranges are halved, which bounds the recursion.
constexpr int deepest = 64;

/// The cost measure of Conty Estevez and Kulla (surface area orientation heuristic): intensity times solid angle of emission times size.
/// The size is that of the bounding sphere instead of the box, so that it is positive for lights on a line.
static double costOf(const LightBounds& b) {
    if (!(b.intensity > 0)) return 0;
    const double o = b.normals, w = std::min(o + b.emission, pi);
    const double directions =
        2 * pi * (1 - std::cos(o)) + pi / 2 * (2 * w * std::sin(o) - std::cos(o - 2 * w) - 2 * o * std::sin(o) + std::cos(o));
    return b.intensity * directions * b.box.radius() * b.box.radius();
}

class LightTreeBuilder {
public:
    explicit LightTreeBuilder(const std::vector<LightBounds>& lights) : lights_(lights) {
        for (uint i = 0; i < lights.size(); ++i)
            if (lights[i].intensity > 0) order_.push_back(i);
    }

    LightTree build() {
        tree_.leaves.assign(lights_.size(), NONE);
        tree_.lights = order_.size();
        if (order_.empty()) return std::move(tree_);
        grow(0, order_.size(), 0);
        emit(0, NONE, 1);
        return std::move(tree_);
    }

private:
    /// A node of the binary tree. left 0: a single light.
    struct Node { LightBounds bounds; size_t left = 0, right = 0; uint light = NONE; double cost = 0; };

    size_t grow(size_t begin, size_t end, int depth) {
        const size_t at = nodes_.size();
        nodes_.emplace_back();
        if (end - begin == 1) {
            nodes_[at].light = order_[begin];
            nodes_[at].bounds = lights_[order_[begin]];
            return at;
        }
        const size_t middle = depth > deepest ? begin + (end - begin) / 2 : split(begin, end);
        const size_t l = grow(begin, middle, depth + 1), r = grow(middle, end, depth + 1);
        Node& n = nodes_[at];
        n.left = l; n.right = r;
        n.bounds = unite(nodes_[l].bounds, nodes_[r].bounds);
        n.cost = costOf(n.bounds);
        return at;
    }

    /// Bounds of the lights of a bucket, in two passes: the mean axis first, then the cone around it.
    struct Bucket {
        LightBounds bounds{.axis = glm::dvec3(0)};
        double leastCosine = 1, ownAngle = 0;
        void addPlace(const LightBounds& b) {
            bounds.box.grow(b.box);
            bounds.intensity += b.intensity;
            bounds.emission = std::max(bounds.emission, b.emission);
            bounds.twoSided |= b.twoSided;
            bounds.axis += b.intensity * b.axis;
        }
        void meanAxis() {
            const double length = glm::length(bounds.axis);
            bounds.axis = length > 1e-9 * bounds.intensity ? bounds.axis / length : glm::dvec3(0, 0, 1);
        }
        void addCone(const LightBounds& b) {
            leastCosine = std::min(leastCosine, glm::dot(bounds.axis, b.axis));
            ownAngle = std::max(ownAngle, b.normals);
        }
        void finish() { bounds.normals = std::min(pi, std::acos(std::clamp(leastCosine, -1.0, 1.0)) + ownAngle); }
    };

    /// Partitions a range at the split of least cost, or in the middle if no split separates anything. Returns where.
    size_t split(size_t begin, size_t end) {
        Box all, centers;
        for (size_t i = begin; i < end; ++i) {
            all.grow(lights_[order_[i]].box);
            centers.grow(lights_[order_[i]].box.center());
        }
        const glm::dvec3 size = centers.high - centers.low, whole = all.high - all.low;
        const double longest = std::max({whole.x, whole.y, whole.z});
        const auto bucketOf = [&](uint light, int axis) {
            const double at = (lights_[light].box.center()[axis] - centers.low[axis]) / size[axis];
            return std::clamp(static_cast<int>(at * buckets), 0, buckets - 1);
        };
        double least = 0;
        int bestAxis = -1, bestCut = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(size[axis] > 1e-6 * longest)) continue;
            std::array<Bucket, buckets> bucket;
            for (size_t i = begin; i < end; ++i) bucket[static_cast<size_t>(bucketOf(order_[i], axis))].addPlace(lights_[order_[i]]);
            for (Bucket& b : bucket) b.meanAxis();
            for (size_t i = begin; i < end; ++i) bucket[static_cast<size_t>(bucketOf(order_[i], axis))].addCone(lights_[order_[i]]);
            for (Bucket& b : bucket) b.finish();

            /* Long thin parts are worse than their size suggests */
            const double thin = longest / std::max(whole[axis], 1e-9 * longest);
            std::array<double, buckets> below{};
            LightBounds sum;
            for (size_t cut = 1; cut < buckets; ++cut) {
                sum = unite(sum, bucket[cut - 1].bounds);
                below[cut] = sum.intensity > 0 ? costOf(sum) : -1;
            }
            sum = {};
            for (size_t cut = buckets - 1; cut >= 1; --cut) {
                sum = unite(sum, bucket[cut].bounds);
                if (below[cut] < 0 || !(sum.intensity > 0)) continue;
                const double cost = thin * (below[cut] + costOf(sum));
                if (bestAxis >= 0 && cost >= least) continue;
                least = cost; bestAxis = axis; bestCut = static_cast<int>(cut);
            }
        }
        if (bestAxis < 0) return begin + (end - begin) / 2;
        const auto first = order_.begin() + static_cast<std::ptrdiff_t>(begin), last = order_.begin() + static_cast<std::ptrdiff_t>(end);
        const auto middle = std::stable_partition(first, last, [&](uint light) { return bucketOf(light, bestAxis) < bestCut; });
        return static_cast<size_t>(middle - order_.begin());
    }

    /// Emits a node with up to eight children: opens the child with the highest cost until it is full. Returns its index.
    uint emit(size_t root, uint parent, int depth) {
        tree_.depth = std::max(tree_.depth, depth);
        std::vector<size_t> children{root};
        while (children.size() < LIGHT_TREE_WIDTH) {
            const auto opens = [&](size_t a, size_t b) { return openingOf(a) < openingOf(b); };
            const auto worst = std::max_element(children.begin(), children.end(), opens);
            if (nodes_[*worst].left == 0) break;
            const Node& n = nodes_[*worst];
            *worst = n.left;
            children.push_back(n.right);
        }
        const uint at = static_cast<uint>(tree_.nodes.size());
        tree_.nodes.emplace_back();
        tree_.nodes[at].parent = parent;
        for (uint i = 0; i < LIGHT_TREE_WIDTH; ++i) {
            setChild(tree_.nodes[at], i, i < children.size() ? nodes_[children[i]].bounds : LightBounds{});
            if (i >= children.size()) continue;
            const Node& child = nodes_[children[i]];
            const uint place = at * LIGHT_TREE_WIDTH + i;
            if (child.left == 0) tree_.leaves[child.light] = place;
            const uint reference = child.left == 0 ? LIGHT_BIT | child.light : emit(children[i], place, depth + 1);
            tree_.nodes[at].child[i] = reference;
        }
        return at;
    }
    /// The priority for opening a child; single lights come last and are never opened.
    double openingOf(size_t node) const { return nodes_[node].left == 0 ? -1 : nodes_[node].cost; }

    /// Bounds rounded outwards.
    static void setChild(light_node& node, uint i, const LightBounds& b) {
        const bool used = b.intensity > 0;
        const glm::dvec3 center = used ? b.box.center() : glm::dvec3(0);
        const auto set = [&](float (&lanes)[LIGHT_TREE_WIDTH], double value) { lanes[i] = static_cast<float>(value); };
        set(node.x, center.x); set(node.y, center.y); set(node.z, center.z);
        set(node.radius, used ? b.box.radius() * (1 + 1e-5) + 1e-6 : 0);
        set(node.axis_x, b.axis.x); set(node.axis_y, b.axis.y); set(node.axis_z, b.axis.z);
        set(node.cos_normals, b.normals >= pi ? -1 : std::cos(std::min(b.normals + 1e-4, pi)));
        set(node.cos_emission, std::max(std::cos(b.emission), 0.0));
        set(node.intensity, b.intensity);
        node.two_sided[i] = b.twoSided ? ~0u : 0u;
        node.child[i] = NONE;
    }

    const std::vector<LightBounds>& lights_;
    std::vector<uint> order_;
    std::vector<Node> nodes_;
    LightTree tree_;
};

LightTree buildLightTree(const std::vector<LightBounds>& lights) { return LightTreeBuilder(lights).build(); }

}  // namespace eikonal
