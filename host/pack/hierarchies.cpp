#include "pack/hierarchies.h"

#include <algorithm>
#include <chrono>

namespace eikonal {
namespace {

class HierarchyBuilder {
public:
    HierarchyBuilder(const Hierarchies& from, GeometryTables& tables, SceneCounts& counts, Diagnostics& diagnostics)
        : from_(from), world_(from.world), tables_(tables), counts_(counts), diagnostics_(diagnostics) {}

    /// Builds the objects' hierarchies first, since the world's hierarchy holds their boxes.
    void build() {
        const auto start = std::chrono::steady_clock::now();
        BvhTables bvh;
        std::vector<BvhRoot> roots;
        for (const Group& g : from_.groups) roots.push_back(g.isEmpty() ? BvhRoot{} : build(bvh, g));
        tables_.instances.reserve(from_.placed.size());
        world_.boxed.reserve(world_.boxed.size() + from_.placed.size());
        for (const PlacedGroup& p : from_.placed) place(p, from_.groups[p.group], roots[p.group]);
        const BvhRoot root = build(bvh, world_, true);
        tables_.nodes = std::move(bvh.nodes);
        tables_.triangle_lines = std::move(bvh.triangleLines);
        tables_.leaf_elements = std::move(bvh.leafElements);
        counts_.bvhDepth = root.depth;
        counts_.buildSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

private:
    BvhRoot build(BvhTables& bvh, const Group& group, bool isWorld = false) {
        std::vector<TriangleRange> ranges;
        for (const Group::Triangles& t : group.triangles)
            ranges.push_back({tables_.positions.data() + t.firstVertex, tables_.indices.data() + t.firstIndex, t.count, t.firstElement});
        const BvhRoot root = buildBvh(bvh, ranges, group.boxed, {.world = isWorld});
        if (root.dropped > 0) diagnostics_.info(std::to_string(root.dropped) + " degenerate elements left out");
        return root;
    }

    void place(const PlacedGroup& placed, const Group& group, const BvhRoot& root) {
        if (group.isEmpty()) return;
        glm::dmat4 sceneFromGroup = world_.space.sceneFromWorld() * placed.worldFromGroup;
        for (const Place& p : placed.motion) sceneFromGroup *= p.start;
        sceneFromGroup *= group.space.worldFromScene();
        instance packed{toAffine(glm::inverse(sceneFromGroup)), toAffine(sceneFromGroup), root.root, 0, 0, placed.id};
        const Box own{{root.low.x, root.low.y, root.low.z}, {root.high.x, root.high.y, root.high.z}};
        const bool moves = !placed.motion.empty();
        const Box box = moves ? addMotions(packed, placed.motion, group.space, own) : transformed(own, sceneFromGroup);
        addBox(world_, box, static_cast<uint>(tables_.instances.size()), leaf_instances);
        tables_.instances.push_back(packed);
    }

    /// Fills in the motions of an instance; returns the bounds of its moving box in scene space.
    Box addMotions(instance& packed, const std::vector<Place>& places, const SceneSpace& group, const Box& box) {
        const SceneSpace& scene = world_.space;
        packed.first_motion = static_cast<uint>(tables_.motions.size());
        packed.motion_count = static_cast<uint>(places.size());
        std::vector<Motion> motions;
        for (size_t i = 0; i < places.size(); ++i) {
            motions.push_back(places[i].motion());
            tables_.motions.push_back(motions[i].pack(i == 0 ? scene : SceneSpace{}, i + 1 == places.size() ? group : SceneSpace{}));
        }
        Box reach = transformed(boundsInMotion(motions, transformed(box, group.worldFromScene()), from_.seen), scene.sceneFromWorld());
        /* Enlarge it by the rounding of the device's interpolated transform */
        const double rounding = 1e-6 * (glm::length(reach.high - reach.low) + glm::length(reach.center()));
        reach.low -= rounding;
        reach.high += rounding;
        return reach;
    }

    const Hierarchies& from_;
    Group world_;          ///< with the boxes of the instances
    GeometryTables& tables_;
    SceneCounts& counts_;
    Diagnostics& diagnostics_;
};

}  // namespace

void Hierarchies::build(GeometryTables& tables, SceneCounts& counts, Diagnostics& diagnostics) const {
    HierarchyBuilder(*this, tables, counts, diagnostics).build();
}

}  // namespace eikonal
