#include "pack/geometry.h"

#include "kinds/shape_kind.h"

#include <algorithm>
#include <array>
#include <map>

namespace eikonal {

class GeometryPacker {
public:
    explicit GeometryPacker(const GeometryPacking& in) : in_(in) {}

    Hierarchies pack() {
        const Scene& scene = in_.context.scene;
        countUses();
        reserveTables();
        Group& world = result_.world;
        world.space = in_.context.space;
        result_.seen = timesSeen(scene);
        for (size_t i = 0; i < scene.shapes.size(); ++i)
            if (!scene.shapes[i].worldFromObjectAtEnd)
                packShape(in_, world, scene.shapes[i], {scene.shapes[i].worldFromObject}, false, static_cast<uint>(i + 1));
        addMovingShapes();
        groupOfObject_.assign(scene.objects.size(), noGroup);
        movingInObject_.resize(scene.objects.size());
        for (size_t i = 0; i < scene.objects.size(); ++i) addObject(i);
        result_.placed.reserve(result_.placed.size() + scene.instances.size());
        for (size_t i = 0; i < scene.instances.size(); ++i)
            addInstance(world, scene.instances[i], static_cast<uint>(scene.shapes.size() + i + 1));
        return std::move(result_);
    }

private:
    static constexpr size_t noGroup = ~size_t(0);

    void countUses() {
        uses_.assign(in_.context.scene.objects.size(), 0);
        for (const Instance& i : in_.context.scene.instances) uses_[static_cast<size_t>(i.object)] += i.worldFromObjectAtEnd ? 2 : 1;
    }

    /// Reserves the large tables: a table that grows is copied, so it needs its memory twice.
    void reserveTables() {
        size_t positions = 0, normals = 0, tangents = 0, uvs = 0, indices = 0, elements = 0;
        const auto count = [&](const Shape& s) {
            if (!s.mesh) return;
            const Mesh* mesh = s.mesh.get();
            positions += mesh->positions.size();
            normals += mesh->normals.size();
            tangents += mesh->tangents.size();
            uvs += mesh->uvs.size();
            indices += mesh->indices.size();
            elements += mesh->indices.size() / static_cast<size_t>(s.kind->traits.corners);
        };
        for (const Shape& s : in_.context.scene.shapes) count(s);
        for (size_t i = 0; i < uses_.size(); ++i)
            if (uses_[i])
                for (const Shape& s : in_.context.scene.objects[i].shapes) count(s);
        GeometryTables& tables = in_.tables;
        tables.positions.reserve(positions);
        tables.normals.reserve(normals);
        tables.tangents.reserve(tangents);
        tables.uvs.reserve(uvs);
        tables.indices.reserve(indices);
        tables.element_shapes.reserve(elements);
    }

    /// Makes a group of shapes. Its space fits their bounds, for the same precision as scene space.
    struct Member { const Shape* shape; glm::dmat4 groupFromObject; uint id; };
    size_t addGroup(const std::vector<Member>& members) {
        Box box;
        for (const Member& m : members) box.grow(m.shape->kind->traits.bound(*m.shape, m.groupFromObject));
        Group group;
        group.space = spaceOf(box);
        for (const Member& m : members) packShape(in_, group, *m.shape, {m.groupFromObject}, true, m.id);
        result_.groups.push_back(std::move(group));
        return result_.groups.size() - 1;
    }

    /// Shapes with the same motion become one group.
    void addMovingShapes() {
        const auto& shapes = in_.context.scene.shapes;
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
            place(addGroup(members), {{s.worldFromObject, s.worldFromObjectAtEnd}}, 0, s.where);
        }
    }

    /// The groups of an object: one for its static shapes, unless it is instanced once and becomes part of the world, and one for each
    /// moving shape.
    void addObject(size_t index) {
        std::vector<Member> still;
        for (const Shape& s : in_.context.scene.objects[index].shapes) {
            if (s.worldFromObjectAtEnd) { if (uses_[index]) movingInObject_[index].push_back({&s, addGroup({{&s, glm::dmat4(1), 0}})}); }
            else still.push_back({&s, s.worldFromObject, 0});
        }
        if (uses_[index] > 1) groupOfObject_[index] = addGroup(still);
    }

    void addInstance(Group& world, const Instance& i, uint id) {
        const size_t object = static_cast<size_t>(i.object);
        const Place inWorld{i.worldFromObject, i.worldFromObjectAtEnd};
        for (const auto& [shape, group] : movingInObject_[object])
            place(group, {inWorld, {shape->worldFromObject, shape->worldFromObjectAtEnd}}, id, i.where);
        if (groupOfObject_[object] != noGroup) { place(groupOfObject_[object], {inWorld}, id, i.where); return; }
        for (const Shape& s : in_.context.scene.objects[object].shapes)
            if (!s.worldFromObjectAtEnd)
                packShape(in_, world, s, {s.worldFromObject, i.worldFromObject}, true, id);
    }

    /// Places a group in the world.
    void place(size_t group, const std::vector<Place>& places, uint id, const SourceLocation& where) {
        if (result_.groups[group].isEmpty()) return;
        const auto require = [&](Feature feature) {
            if (!in_.context.has(feature)) in_.context.require(feature, where.toString());
        };
        require(Feature::INSTANCES);
        PlacedGroup placed{static_cast<uint>(group), id};
        if (std::ranges::any_of(places, [](const Place& p) { return p.end.has_value(); })) {
            require(Feature::MOTION);
            placed.motion = places;
        } else
            for (const Place& p : places) placed.worldFromGroup *= p.start;
        result_.placed.push_back(std::move(placed));
    }

    const GeometryPacking& in_;
    Hierarchies result_;
    std::vector<int> uses_;                 ///< instances of each object; moving ones count twice, so they never join the world
    std::vector<size_t> groupOfObject_;
    std::vector<std::vector<std::pair<const Shape*, size_t>>> movingInObject_;   ///< moving shapes of each object, and their groups
};

Hierarchies packGeometry(const GeometryPacking& in) { return GeometryPacker(in).pack(); }

}  // namespace eikonal
