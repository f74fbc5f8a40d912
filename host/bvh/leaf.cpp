#include "bvh/leaf.h"

#include "bvh/padding.h"

#include <bit>

namespace eikonal {

/// Elements with larger coordinates are dropped, because the slab test would overflow.
constexpr float farthest = 1e17f;

static bool isUsable(float4 point) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::fabs(point[axis]) <= farthest)) return false;
    return true;
}

static float4 load(const vec3& p) { return float4{p.x, p.y, p.z, 0}; }

static bool equal(const vec3& a, const vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

size_t Sources::size() const {
    size_t count = others.size();
    for (const TriangleRange& range : triangles) count += range.count;
    return count;
}

std::optional<Reference> Sources::reference(uint range, size_t i) const {
    const TriangleRange& from = triangles[range];
    const uint* corner = from.indices + 3 * i;
    const vec3 &a = from.positions[corner[0]], &b = from.positions[corner[1]], &c = from.positions[corner[2]];
    /* With two equal corners all edge functions cancel, so no ray can hit it. Other slivers are kept because they may close a gap */
    if (equal(a, b) || equal(b, c) || equal(c, a)) return std::nullopt;
    if (!isUsable(load(a)) || !isUsable(load(b)) || !isUsable(load(c))) return std::nullopt;
    WideBox box = WideBox::empty();
    box.grow(load(a)); box.grow(load(b)); box.grow(load(c));
    return Reference(box, leaf_triangles, range, static_cast<uint>(i));
}

std::optional<Reference> Sources::reference(size_t other) const {
    const BoxedElement& element = others[other];
    const WideBox box = {load(element.low), load(element.high)};
    if (!isUsable(box.low) || !isUsable(box.high)) return std::nullopt;
    return Reference(box, element.kind, 0, static_cast<uint>(other));
}

static uint leafReference(leaf_kind kind, size_t count, size_t first) {
    return LEAF_BIT | static_cast<uint>(kind) << LEAF_KIND_SHIFT | static_cast<uint>(count - 1) << LEAF_COUNT_SHIFT |
           static_cast<uint>(first);
}

/* Appends the lines of a leaf of triangles (include/eikonal/bvh.h) */
static void appendTriangles(Table<triangle_line>& lines, const Sources& sources, std::span<const Reference> references) {
    constexpr size_t words = std::size(triangle_line{}.words);
    const size_t count = references.size(), first = lines.size();
    lines.resize(first + (TRIANGLE_WORDS * count + words - 1) / words, triangle_line{});
    const auto word = [&](size_t row, size_t i) -> float& {
        return lines[first + (row * count + i) / words].words[(row * count + i) % words];
    };
    for (size_t i = 0; i < count; ++i) {
        const TriangleRange& from = sources.triangles[references[i].source()];
        const uint index = references[i].index();
        for (size_t v = 0; v < 3; ++v) {
            const vec3& p = from.positions[from.indices[3 * static_cast<size_t>(index) + v]];
            word(3 * v, i) = p.x;
            word(3 * v + 1, i) = p.y;
            word(3 * v + 2, i) = p.z;
        }
        word(9, i) = std::bit_cast<float>((from.firstElement + index) | ELEMENT_MARK);
    }
}

uint appendLeaf(BvhTables& tables, const Sources& sources, std::span<const Reference> references) {
    const leaf_kind kind = references[0].kind();
    if (kind == leaf_instances) return leafReference(kind, 1, sources.others[references[0].index()].reference);
    if (kind == leaf_triangles) {
        const size_t first = tables.triangleLines.size();
        appendTriangles(tables.triangleLines, sources, references);
        return leafReference(kind, references.size(), first);
    }
    const size_t first = tables.leafElements.size();
    for (const Reference& r : references) tables.leafElements.push_back(sources.others[r.index()].reference);
    return leafReference(kind, references.size(), first);
}

void setChild(bvh_node& node, int lane, const WideBox& box, uint child) {
    const WideBox padded = padBox(box);
    for (int axis = 0; axis < 3; ++axis) {
        node.bounds[2 * axis][lane] = padded.low[axis];
        node.bounds[2 * axis + 1][lane] = padded.high[axis];
    }
    node.child[lane] = child;
}

bvh_node emptyNode() {
    bvh_node node;
    for (int lane = 0; lane < BVH_WIDTH; ++lane) {
        for (int axis = 0; axis < 3; ++axis) {
            node.bounds[2 * axis][lane] = 10 * farthest;
            node.bounds[2 * axis + 1][lane] = -10 * farthest;
        }
        node.child[lane] = NONE;
        node.order[lane] = 0x76543210u;
    }
    return node;
}

}  // namespace eikonal
