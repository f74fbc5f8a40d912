// Shapes, objects, instances, and the hierarchy over them.

#include "pack/curves.h"
#include "pack/implicit.h"
#include "pack/motion.h"
#include "pack/packer.h"

#include "bvh/build.h"
#include "eikonal/stages.h"

#include <array>
#include <chrono>
#include <cmath>
#include <map>

namespace eikonal {

template <class... F> struct Overloaded : F... { using F::operator()...; };

/// The elements of one hierarchy: of the world, or of an object that is instanced or moves.
struct Group {
    SceneSpace space;               ///< the space that the hierarchy is built in, from the object's own
    struct Triangles { size_t firstVertex, firstIndex, count; uint firstElement; };
    std::vector<Triangles> triangles;
    std::vector<BoxedElement> boxed;
};

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
            if (!scene.shapes[i].worldFromObjectAtEnd) addShape(world, scene.shapes[i], scene.shapes[i].worldFromObject, false, false, static_cast<uint>(i + 1));
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
        for (const Member& m : members) addShape(group, *m.shape, m.groupFromObject, true, false, m.id);
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
            if (!s.worldFromObjectAtEnd) addShape(world, s, i.worldFromObject * s.worldFromObject, true, swapsHandedness(i.worldFromObject), id);
    }

    void addShape(Group& group, const Shape& s, const glm::dmat4& worldFromObject, bool inObject, bool instanceSwaps, uint id) {
        const uint materialIndex = packedMaterial(packer_, s.material);
        const bool isInterface = tables_.materials[materialIndex].hop == hop_passage;
        const bool emits = s.areaLight != none && !inObject && countsMaterials(packer_.scene.integrator);
        if (s.areaLight != none && inObject)
            packer_.diagnostics.unsupported("area light in object", s.where, "area lights in instanced objects do not emit (as in pbrt-v4)");
        if (isInterface && !emits && !packer_.hasMedia) return;

        shape packed{};
        packed.material = materialIndex;
        packed.id = id;
        packed.first_element = static_cast<uint>(tables_.element_shapes.size());
        packed.first_normal = packed.first_uv = packed.quadric = packed.first_light = packed.alpha = packed.emission = NONE;
        packed.inside = packed.outside = NONE;
        if (isInterface) packed.flags |= shape_is_interface;
        if (packer_.hasMedia && s.interface) {
            packed.flags |= shape_has_interface;
            packed.inside = s.interface->inside == none ? NONE : static_cast<uint>(s.interface->inside);
            packed.outside = s.interface->outside == none ? NONE : static_cast<uint>(s.interface->outside);
        }
        if (s.alpha.texture != none || s.alpha.value.value() < 1) {
            packer_.packed.require(Feature::ALPHA, s.where.toString());
            packed.alpha = packInput(packer_, s.alpha);
        }
        const glm::dmat4 groupFromObject = group.space.sceneFromWorld() * worldFromObject;
        const size_t elements = std::visit(Overloaded{
            [&](const TriangleMesh& m) { return addTriangles(group, packed, s, *m.mesh, groupFromObject); },
            [&](const BilinearMesh& m) { return addPatches(group, packed, s, *m.mesh, groupFromObject); },
            [&](const Sphere& q) { return addSphere(group, packed, s, q, groupFromObject, instanceSwaps); },
            [&](const Disk& q) { return addDisk(group, packed, s, q, groupFromObject, instanceSwaps); },
            [&](const Cylinder& q) { return addCylinder(group, packed, s, q, groupFromObject, instanceSwaps); },
            [&](const CurveShape& c) { return addCurve(group, packed, s, *c.curve, groupFromObject, instanceSwaps); },
            [&](const ImplicitSurface& f) { return addImplicit(group, packed, s, f, groupFromObject, instanceSwaps); }}, s.kind);
        if (elements == 0) return;
        tables_.element_shapes.insert(tables_.element_shapes.end(), elements, static_cast<uint>(tables_.shapes.size()));
        if (emits) packAreaLight(packer_, s, packed, groupFromObject, elements);
        tables_.shapes.push_back(packed);
    }

    void addVertices(shape& packed, const Shape& s, const Mesh& mesh, const glm::dmat4& m) {
        packed.first_vertex = static_cast<uint>(tables_.positions.size());
        packed.first_index = static_cast<uint>(tables_.indices.size());
        if (s.reverseOrientation != swapsHandedness(m)) packed.flags |= shape_reversed;
        tables_.positions.reserve(tables_.positions.size() + mesh.positions.size());
        for (const glm::vec3& p : mesh.positions) tables_.positions.push_back(toVec3(transformPoint(m, p)));
        tables_.indices.insert(tables_.indices.end(), mesh.indices.begin(), mesh.indices.end());
        if (!mesh.normals.empty()) {
            packed.first_normal = static_cast<uint>(tables_.normals.size());
            for (const glm::vec3& n : mesh.normals) tables_.normals.push_back(toVec3(transformNormal(m, n) * (s.reverseOrientation ? -1.0 : 1.0)));
        }
        if (!mesh.uvs.empty()) {
            packed.first_uv = static_cast<uint>(tables_.uvs.size());
            for (const glm::vec2& uv : mesh.uvs) tables_.uvs.push_back({uv.x, uv.y});
        }
    }

    size_t addTriangles(Group& group, shape& packed, const Shape& s, const Mesh& mesh, const glm::dmat4& m) {
        const size_t count = mesh.indices.size() / 3;
        if (count == 0) return 0;
        packed.kind = shape_triangle;
        addVertices(packed, s, mesh, m);
        group.triangles.push_back({packed.first_vertex, packed.first_index, count, packed.first_element});
        packer_.packed.require(Feature::SHAPE_TRIANGLE, s.where.toString());
        packer_.packed.counts.triangles += count;
        return count;
    }

    size_t addPatches(Group& group, shape& packed, const Shape& s, const Mesh& mesh, const glm::dmat4& m) {
        const size_t count = mesh.indices.size() / 4;
        if (count == 0) return 0;
        packed.kind = shape_bilinear;
        addVertices(packed, s, mesh, m);
        for (size_t i = 0; i < count; ++i) {
            Box box;
            for (int c = 0; c < 4; ++c) {
                const vec3 p = tables_.positions[packed.first_vertex + mesh.indices[4 * i + static_cast<size_t>(c)]];
                box.grow({p.x, p.y, p.z});
            }
            addBox(group, box, packed.first_element + static_cast<uint>(i));
        }
        packer_.packed.require(Feature::SHAPE_BILINEAR, s.where.toString());
        packer_.packed.counts.patches += count;
        return count;
    }

    size_t addQuadric(Group& group, shape& packed, const Shape& s, quadric q, const glm::dmat4& m, bool instanceSwaps) {
        /* The normal is made in object space and transformed, so only the shape's own transform can flip it */
        if (s.reverseOrientation != (swapsHandedness(m) != instanceSwaps)) packed.flags |= shape_reversed;
        packed.quadric = static_cast<uint>(tables_.quadrics.size());
        q.scene_from_object = toAffine(m);
        q.object_from_scene = toAffine(glm::inverse(m));
        tables_.quadrics.push_back(q);
        addBox(group, boundsOf(s, m), packed.first_element);
        return 1;
    }

    static float radians(double degrees) { return static_cast<float>(glm::radians(std::clamp(degrees, 0.0, 360.0))); }

    size_t addSphere(Group& group, shape& packed, const Shape& s, const Sphere& sphere, const glm::dmat4& m, bool instanceSwaps) {
        packed.kind = shape_sphere;
        packer_.packed.require(Feature::SHAPE_SPHERE, s.where.toString());
        ++packer_.packed.counts.quadrics;
        quadric q{};
        q.radius = static_cast<float>(sphere.radius);
        q.z_min = static_cast<float>(std::clamp(std::min(sphere.zMin, sphere.zMax), -sphere.radius, sphere.radius));
        q.z_max = static_cast<float>(std::clamp(std::max(sphere.zMin, sphere.zMax), -sphere.radius, sphere.radius));
        q.phi_max = radians(sphere.phiMax);
        return addQuadric(group, packed, s, q, m, instanceSwaps);
    }

    size_t addDisk(Group& group, shape& packed, const Shape& s, const Disk& disk, const glm::dmat4& m, bool instanceSwaps) {
        packed.kind = shape_disk;
        packer_.packed.require(Feature::SHAPE_DISK, s.where.toString());
        ++packer_.packed.counts.quadrics;
        quadric q{};
        q.radius = static_cast<float>(disk.radius);
        q.inner_radius = static_cast<float>(disk.innerRadius);
        q.z_min = q.z_max = static_cast<float>(disk.height);
        q.phi_max = radians(disk.phiMax);
        return addQuadric(group, packed, s, q, m, instanceSwaps);
    }

    size_t addCylinder(Group& group, shape& packed, const Shape& s, const Cylinder& cylinder, const glm::dmat4& m, bool instanceSwaps) {
        packed.kind = shape_cylinder;
        packer_.packed.require(Feature::SHAPE_CYLINDER, s.where.toString());
        ++packer_.packed.counts.quadrics;
        quadric q{};
        q.radius = static_cast<float>(cylinder.radius);
        q.z_min = static_cast<float>(cylinder.zMin);
        q.z_max = static_cast<float>(cylinder.zMax);
        q.phi_max = radians(cylinder.phiMax);
        return addQuadric(group, packed, s, q, m, instanceSwaps);
    }

    size_t addImplicit(Group& group, shape& packed, const Shape& s, const ImplicitSurface& surface, const glm::dmat4& m, bool instanceSwaps) {
        packed.kind = shape_implicit;
        packed.first_index = static_cast<uint>(tables_.implicits.size());
        packer_.packed.require(Feature::SHAPE_IMPLICIT, s.where.toString());
        const std::vector<implicit_instruction> program = implicitProgram(*surface.F, s.where);
        tables_.implicits.push_back({toVec3(surface.low), toVec3(surface.high), static_cast<uint>(tables_.implicit_instructions.size()), static_cast<uint>(program.size())});
        tables_.implicit_instructions.insert(tables_.implicit_instructions.end(), program.begin(), program.end());
        ++packer_.packed.counts.implicits;
        return addQuadric(group, packed, s, quadric{}, m, instanceSwaps);
    }

    /// In the space of the hierarchy if its widths and its left and right stay what they are, else with maps, which each ray then goes through.
    size_t addCurve(Group& group, shape& packed, const Shape& s, const Curve& description, const glm::dmat4& m, bool instanceSwaps) {
        packed.kind = shape_curve;
        if (s.reverseOrientation != (swapsHandedness(m) != instanceSwaps)) packed.flags |= shape_reversed;
        packed.first_index = static_cast<uint>(tables_.curve_segments.size());
        packed.splits = curveSplits(description);
        const double scale = swapsHandedness(m) ? 0 : uniformScale(m);
        if (scale == 0) {
            packed.quadric = static_cast<uint>(tables_.quadrics.size());
            quadric maps{};
            maps.scene_from_object = toAffine(m);
            maps.object_from_scene = toAffine(glm::inverse(m));
            tables_.quadrics.push_back(maps);
        }
        const uint parts = 1u << packed.splits;
        uint element = packed.first_element;
        for (const CurveSegment& segment : description.segments) {
            const curve c = packSegment(segment, description.kind, scale > 0 ? m : glm::dmat4(1), scale > 0 ? scale : 1);
            tables_.curve_segments.push_back(c);
            for (uint part = 0; part < parts; ++part, ++element) {
                if (c.width[0] <= 0 && c.width[1] <= 0) continue;
                const Box box = boundsOfPart(c, part, packed.splits);
                addBox(group, scale > 0 ? box : transformed(box, m), element);
            }
        }
        packer_.packed.require(Feature::SHAPE_CURVE, s.where.toString());
        packer_.packed.counts.curves += description.segments.size();
        return element - packed.first_element;
    }

    /// Padded by more than the rounding of a shape's own intersection test, in units of the box's largest coordinate.
    static void addBox(Group& group, const Box& box, uint reference, leaf_kind kind = leaf_elements) {
        const glm::dvec3 reach = glm::max(glm::abs(box.low), glm::abs(box.high));
        const double padding = 32 * 6e-8 * std::max({reach.x, reach.y, reach.z});
        group.boxed.push_back({toVec3(box.low - padding), toVec3(box.high + padding), reference, kind});
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
        tables_.triangle_blocks = std::move(bvh.triangleBlocks);
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
