#include "bvh/build.h"

#include "bvh/child_order.h"
#include "bvh/split.h"
#include "bvh/subtree.h"
#include "error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace eikonal {

/// Ranges up to this size are built and collapsed by one thread.
constexpr uint subtreeSize = 4096;
/// Elements per parallel task.
constexpr size_t chunkSize = 1 << 16;

// ---- references ---------------------------------------------------------------------------------------------------------

/// Memory that is not zeroed first: each page is first touched by the thread that fills it.
struct References {
    std::unique_ptr<Reference[]> memory;
    size_t count = 0;
    std::span<Reference> all() { return {memory.get(), count}; }
};

static References collectReferences(const Sources& sources) {
    /* Fill chunks of each source in parallel */
    struct Chunk { uint range; size_t begin, end, target, kept; };
    std::vector<Chunk> chunks;
    size_t total = 0;
    const auto cover = [&](uint range, size_t count) {
        for (size_t begin = 0; begin < count; begin += chunkSize) {
            const size_t end = std::min(begin + chunkSize, count);
            chunks.push_back({range, begin, end, total, 0});
            total += end - begin;
        }
    };
    const uint ranges = static_cast<uint>(sources.triangles.size());
    for (uint range = 0; range < ranges; ++range) cover(range, sources.triangles[range].count);
    cover(ranges, sources.others.size());
    References references{std::make_unique_for_overwrite<Reference[]>(total)};
    tbb::parallel_for(size_t{0}, chunks.size(), [&](size_t c) {
        Chunk& chunk = chunks[c];
        for (size_t i = chunk.begin; i < chunk.end; ++i)
            if (const auto r = chunk.range < ranges ? sources.reference(chunk.range, i) : sources.reference(i))
                references.memory[chunk.target + chunk.kept++] = *r;
    });
    /* Close the gaps of dropped elements */
    for (const Chunk& chunk : chunks) {
        if (chunk.target != references.count)
            std::copy_n(&references.memory[chunk.target], chunk.kept, &references.memory[references.count]);
        references.count += chunk.kept;
    }
    return references;
}

// ---- upper part ---------------------------------------------------------------------------------------------------------

/// A subtree, or a single node above other pieces.
struct Piece {
    struct Child;
    Subtree part;                                   ///< for a single node: without its children
    std::vector<Child> children;
    uint firstNode = 0, firstLine = 0, firstElement = 0;  ///< where its tables begin in the joined tables
};
struct Piece::Child { WideBox box; Piece piece; };

/* Divides a range into up to eight child ranges of a node */
static std::vector<Range> divide(std::span<Reference> references, const Range& range, bool halves) {
    std::vector<Range> parts{range};
    const auto splitAt = [&](size_t i) {
        const auto [left, right] = halves ? splitInHalves(references, parts[i]) : splitByCost(references, parts[i]);
        parts[i] = left;
        parts.insert(parts.begin() + static_cast<std::ptrdiff_t>(i) + 1, right);
    };
    if (halves) {
        for (int level = 0; level < 3; ++level)
            for (size_t i = parts.size(); i-- > 0;)
                if (parts[i].size() > 1) splitAt(i);
        return parts;
    }
    /* Split the range with the largest area first, since rays hit it most often */
    while (parts.size() < BVH_WIDTH) {
        size_t widest = parts.size();
        for (size_t i = 0; i < parts.size(); ++i)
            if (!parts[i].fitsLeaf() && (widest == parts.size() || parts[i].box.halfArea() > parts[widest].box.halfArea())) widest = i;
        if (widest == parts.size()) break;
        splitAt(widest);
    }
    return parts;
}

static Piece buildPiece(const Sources& sources, std::span<Reference> references, const Range& range, int maxDepth, bool alwaysNode) {
    Piece piece;
    if (range.size() <= subtreeSize) {
        piece.part = buildSubtree(sources, references, range, maxDepth, alwaysNode);
        return piece;
    }
    const std::vector<Range> parts = divide(references, range, maxDepth <= balancedDepth(range.size()) + 1);
    piece.part.root = 0;
    piece.part.tables.nodes.push_back(emptyNode());
    piece.children.resize(parts.size());
    tbb::parallel_for(size_t{0}, parts.size(), [&](size_t i) {
        piece.children[i] = {parts[i].box, buildPiece(sources, references, parts[i], maxDepth - 1, false)};
    });
    piece.part.cost = range.box.halfArea();
    for (const auto& [box, child] : piece.children) {
        piece.part.depth = std::max(piece.part.depth, child.part.depth + 1);
        piece.part.cost += child.part.cost;
        piece.part.leaves += child.part.leaves;
    }
    return piece;
}

// ---- joining ------------------------------------------------------------------------------------------------------------

/* The reference of a child after its piece's tables were appended to others */
static uint moved(uint child, const Piece& piece) {
    if (child == NONE) return NONE;
    if (!(child & LEAF_BIT)) return child + piece.firstNode;
    const auto kind = static_cast<leaf_kind>((child >> LEAF_KIND_SHIFT) & LEAF_KIND_MASK);
    return child + (kind == leaf_triangles ? piece.firstLine : kind == leaf_elements ? piece.firstElement : 0);
}

/* Numbers pieces depth first, so that nodes visited together are close in memory */
static void place(Piece& piece, std::vector<Piece*>& order, size_t& nodes, size_t& lines, size_t& elements) {
    order.push_back(&piece);
    piece.firstNode = static_cast<uint>(nodes);
    piece.firstLine = static_cast<uint>(lines);
    piece.firstElement = static_cast<uint>(elements);
    nodes += piece.part.tables.nodes.size();
    lines += piece.part.tables.triangleLines.size();
    elements += piece.part.tables.leafElements.size();
    for (auto& [box, child] : piece.children) place(child, order, nodes, lines, elements);
}

static void checkRoom(size_t count, const char* what) {
    if (count > LEAF_FIRST_MASK)
        throw Error(ExitCode::scene,
                    fmt::format("the scene is too large: it needs {} {}, and at most {} are possible", count, what, LEAF_FIRST_MASK));
}

/* Appends all pieces to the tables, with the root at node `root`. */
static void join(BvhTables& tables, Piece& top, uint root) {
    std::vector<Piece*> order;
    const bool append = root == tables.nodes.size();
    size_t nodes = append ? root : tables.nodes.size() - 1, lines = tables.triangleLines.size(), elements = tables.leafElements.size();
    place(top, order, nodes, lines, elements);
    checkRoom(lines, "lines of triangles");
    checkRoom(elements, "elements that are not triangles");
    tables.nodes.resize(nodes);
    tables.triangleLines.resize(lines);
    tables.leafElements.resize(elements);
    tbb::parallel_for(size_t{0}, order.size(), [&](size_t i) {
        Piece& piece = *order[i];
        BvhTables& from = piece.part.tables;
        for (size_t n = 0; n < from.nodes.size(); ++n) {
            bvh_node& node = from.nodes[n];
            for (uint& child : node.child) child = moved(child, piece);
            for (size_t lane = 0; lane < piece.children.size(); ++lane) {
                const auto& [box, child] = piece.children[lane];
                setChild(node, static_cast<int>(lane), box, moved(child.part.root, child));
            }
            orderChildren(node);
            tables.nodes[&piece == &top && n == 0 ? root : piece.firstNode + n] = node;
        }
        std::copy(from.triangleLines.begin(), from.triangleLines.end(), tables.triangleLines.begin() + piece.firstLine);
        std::copy(from.leafElements.begin(), from.leafElements.end(), tables.leafElements.begin() + piece.firstElement);
        from = {};
    });
}

BvhRoot buildBvh(BvhTables& tables, std::span<const TriangleRange> triangles, std::span<const BoxedElement> others,
                 const BvhOptions& options) {
    const Sources sources{triangles, others};
    if (sources.size() >= ELEMENT_MARK) throw Error(ExitCode::scene, fmt::format("the scene is too large: {} elements", sources.size()));
    for (const BoxedElement& other : others)
        if (other.kind == leaf_instances) checkRoom(other.reference, "instances");
    References references = collectReferences(sources);

    BvhRoot result;
    result.root = options.world ? 0 : static_cast<uint>(tables.nodes.size());
    result.elements = references.count;
    result.dropped = sources.size() - references.count;
    const size_t nodesBefore = tables.nodes.size() - options.world, linesBefore = tables.triangleLines.size();
    if (references.count == 0) {
        if (options.world) tables.nodes[0] = emptyNode();
        else tables.nodes.push_back(emptyNode());
        result.depth = 1;
    } else {
        const Range all = measureRange(references.all(), 0, static_cast<uint>(references.count));
        Piece top = buildPiece(sources, references.all(), all, BVH_MAX_DEPTH, true);
        references = {};
        join(tables, top, result.root);
        result.low = {all.box.low[0], all.box.low[1], all.box.low[2]};
        result.high = {all.box.high[0], all.box.high[1], all.box.high[2]};
        result.depth = top.part.depth;
        result.leaves = top.part.leaves;
        result.cost = all.box.halfArea() > 0 ? top.part.cost / all.box.halfArea() : 0;
    }
    result.nodes = tables.nodes.size() - nodesBefore;
    result.lines = tables.triangleLines.size() - linesBefore;
    return result;
}

}  // namespace eikonal
