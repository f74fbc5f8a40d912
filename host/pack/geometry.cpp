// Objects, instances, and the hierarchy over all shapes.

#include "pack/motion.h"
#include "pack/shapes.h"

#include <array>
#include <chrono>
#include <map>

namespace eikonal {

/// Where something is, and where it is when the motion ends, if it moves.
struct Place {
    glm::dmat4 start{1};
    std::optional<glm::dmat4> end{};
    Motion motion() const { return {start, end.value_or(start)}; }
};

/// A group in the world: places one inside of the other, the outermost first.
struct PlacedGroup { size_t group; std::vector<Place> places; uint id; SourceLocation where; };

class GeometryPacker {
public:
    explicit GeometryPacker(Packer& packer) : packer_(packer), tables_(packer.packed.tables) {}

    void pack() {
        const Scene& scene = packer_.scene;
        countUses();
        Group world;
        world.space = packer_.space;
        for (size_t i = 0; i < scene.shapes.size(); ++i)
            if (!scene.shapes[i].worldFromObjectAtEnd) packShape(packer_, world, scene.shapes[i], scene.shapes[i].worldFromObject, false, false, static_cast<uint>(i + 1));
        addMovingShapes();
        groupOfObject_.assign(scene.objects.size(), noGroup);
        movingInObject_.resize(scene.objects.size());
        for (size_t i = 0; i < scene.objects.size(); ++i) addObject(i);
        for (size_t i = 0; i < scene.instances.size(); ++i) addInstance(world, scene.instances[i], static_cast<uint>(scene.shapes.size() + i + 1));
        buildHierarchies(world);
    }

private:
    static constexpr size_t noGroup = ~size_t(0);

    void countUses() {
        uses_.assign(packer_.scene.objects.size(), 0);
        for (const Instance& i : packer_.scene.instances) uses_[static_cast<size_t>(i.object)] += i.worldFromObjectAtEnd ? 2 : 1;
    }

    /// A group of its own for shapes, whose space is, for the same reason as the scene's, that of their bounds.
    struct Member { const Shape* shape; glm::dmat4 groupFromObject; uint id; };
    size_t addGroup(const std::vector<Member>& members) {
        Box box;
        for (const Member& m : members) box.grow(boundsOf(*m.shape, m.groupFromObject));
        Group group;
        group.space = spaceOf(box);
        for (const Member& m : members) packShape(packer_, group, *m.shape, m.groupFromObject, true, false, m.id);
        groups_.push_back(std::move(group));
        return groups_.size() - 1;
    }

    /// Shapes that move alike become one group.
    void addMovingShapes() {
        const auto& shapes = packer_.scene.shapes;
        std::map<std::array<double, 32>, std::vector<Member>> alike;
        for (size_t i = 0; i < shapes.size(); ++i) {
            const Shape& s = shapes[i];
            if (!s.worldFromObjectAtEnd) continue;
            std::array<double, 32> key;
            for (int k = 0; k < 16; ++k) {
                key[static_cast<size_t>(k)] = s.worldFromObject[k / 4][k % 4];
                key[static_cast<size_t>(k + 16)] = (*s.worldFromObjectAtEnd)[k / 4][k % 4];
            }
            alike[key].push_back({&s, glm::dmat4(1), static_cast<uint>(i + 1)});
        }
        for (const auto& [key, members] : alike) {
            const Shape& s = *members.front().shape;
            placed_.push_back({addGroup(members), {{s.worldFromObject, s.worldFromObjectAtEnd}}, 0, s.where});
        }
    }

    /// The groups of an object: one of all that stands still in it, unless it is used only once and becomes part of the world, and one
    /// for each shape that moves in it.
    void addObject(size_t index) {
        std::vector<Member> still;
        for (const Shape& s : packer_.scene.objects[index].shapes) {
            if (s.worldFromObjectAtEnd) { if (uses_[index]) movingInObject_[index].push_back({&s, addGroup({{&s, glm::dmat4(1), 0}})}); }
            else still.push_back({&s, s.worldFromObject, 0});
        }
        if (uses_[index] > 1) groupOfObject_[index] = addGroup(still);
    }

    void addInstance(Group& world, const Instance& i, uint id) {
        const size_t object = static_cast<size_t>(i.object);
        const Place place{i.worldFromObject, i.worldFromObjectAtEnd};
        for (const auto& [shape, group] : movingInObject_[object])
            placed_.push_back({group, {place, {shape->worldFromObject, shape->worldFromObjectAtEnd}}, id, i.where});
        if (groupOfObject_[object] != noGroup) { placed_.push_back({groupOfObject_[object], {place}, id, i.where}); return; }
        for (const Shape& s : packer_.scene.objects[object].shapes)
            if (!s.worldFromObjectAtEnd) packShape(packer_, world, s, i.worldFromObject * s.worldFromObject, true, swapsHandedness(i.worldFromObject), id);
    }

    BvhRoot build(BvhTables& bvh, const Group& group, bool isWorld = false) {
        std::vector<TriangleRange> ranges;
        for (const Group::Triangles& t : group.triangles)
            ranges.push_back({tables_.positions.data() + t.firstVertex, tables_.indices.data() + t.firstIndex, t.count, t.firstElement});
        const BvhRoot root = buildBvh(bvh, ranges, group.boxed, {.world = isWorld});
        if (root.dropped > 0)
            packer_.diagnostics.info(std::to_string(root.dropped) + " degenerate elements left out");
        return root;
    }

    /// The world's hierarchy holds the boxes of the objects' hierarchies, so those come first.
    void buildHierarchies(Group& world) {
        const auto start = std::chrono::steady_clock::now();
        BvhTables bvh;
        std::vector<BvhRoot> roots;
        for (const Group& g : groups_) roots.push_back(g.triangles.empty() && g.boxed.empty() ? BvhRoot{} : build(bvh, g));
        for (const PlacedGroup& p : placed_) place(world, p, groups_[p.group], roots[p.group]);
        const BvhRoot root = build(bvh, world, true);
        tables_.nodes = std::move(bvh.nodes);
        tables_.triangle_lines = std::move(bvh.triangleLines);
        tables_.leaf_elements = std::move(bvh.leafElements);
        packer_.packed.counts.bvhDepth = root.depth;
        packer_.packed.counts.buildSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    void place(Group& world, const PlacedGroup& placed, const Group& group, const BvhRoot& root) {
        if (group.triangles.empty() && group.boxed.empty()) return;
        glm::dmat4 sceneFromGroup = world.space.sceneFromWorld();
        for (const Place& p : placed.places) sceneFromGroup *= p.start;
        sceneFromGroup *= group.space.worldFromScene();
        instance packed{toAffine(glm::inverse(sceneFromGroup)), toAffine(sceneFromGroup), root.root, 0, 0, placed.id};
        const Box own{{root.low.x, root.low.y, root.low.z}, {root.high.x, root.high.y, root.high.z}};
        const bool moves = std::any_of(placed.places.begin(), placed.places.end(), [](const Place& p) { return p.end.has_value(); });
        const Box box = moves ? addMotions(packed, placed, world.space, group.space, own) : transformed(own, sceneFromGroup);
        addBox(world, box, static_cast<uint>(tables_.instances.size()), leaf_instances);
        tables_.instances.push_back(packed);
        packer_.packed.require(Feature::INSTANCES, placed.where.toString());
    }

    /// Fills in the motions of an instance; returns what its box reaches, in scene space.
    Box addMotions(instance& packed, const PlacedGroup& placed, const SceneSpace& scene, const SceneSpace& group, const Box& box) {
        packer_.packed.require(Feature::MOTION, placed.where.toString());
        packed.first_motion = static_cast<uint>(tables_.motions.size());
        packed.motion_count = static_cast<uint>(placed.places.size());
        std::vector<Motion> motions;
        for (size_t i = 0; i < placed.places.size(); ++i) {
            motions.push_back(placed.places[i].motion());
            tables_.motions.push_back(motions[i].pack(i == 0 ? scene : SceneSpace{}, i + 1 == placed.places.size() ? group : SceneSpace{}));
        }
        Box reach = transformed(boundsInMotion(motions, transformed(box, group.worldFromScene()), timesSeen(packer_.scene)), scene.sceneFromWorld());
        /* For what the device rounds in putting the map together */
        const double rounding = 1e-6 * (glm::length(reach.high - reach.low) + glm::length(reach.center()));
        reach.low -= rounding;
        reach.high += rounding;
        return reach;
    }

    Packer& packer_;
    SceneTables& tables_;
    std::vector<int> uses_;                 ///< of each object; a use that moves counts twice, so that it is never part of the world
    std::vector<Group> groups_;
    std::vector<PlacedGroup> placed_;
    std::vector<size_t> groupOfObject_;
    std::vector<std::vector<std::pair<const Shape*, size_t>>> movingInObject_;   ///< and their groups
};

void packGeometry(Packer& packer) { GeometryPacker(packer).pack(); }

}  // namespace eikonal
