// Shapes, objects, instances, and the hierarchy over them.

#include "pack/packer.h"

#include "bvh/build.h"
#include "eikonal/stages.h"

#include <chrono>
#include <cmath>

namespace eikonal {

template <class... F> struct Overloaded : F... { using F::operator()...; };

/// The elements of one hierarchy: of the world, or of an object that is instanced.
struct Group {
    glm::dmat4 groupFromWorld{1};   ///< to the space that the hierarchy is built in
    struct Triangles { size_t firstVertex, firstIndex, count; uint firstElement; };
    std::vector<Triangles> triangles;
    std::vector<BoxedElement> boxed;
};

class GeometryPacker {
public:
    explicit GeometryPacker(Packer& packer) : packer_(packer), tables_(packer.packed.tables) {}

    void pack() {
        countUses();
        Group world;
        world.groupFromWorld = packer_.space.sceneFromWorld();
        for (const Shape& s : packer_.scene.shapes) addShape(world, s, s.worldFromObject, false, false);
        std::vector<Group> objects(packer_.scene.objects.size());
        for (size_t i = 0; i < objects.size(); ++i)
            if (uses_[i] > 1) addObject(objects[i], packer_.scene.objects[i]);
        for (const Instance& i : packer_.scene.instances) addInstance(world, i);
        buildHierarchies(world, objects);
    }

private:
    void countUses() {
        uses_.assign(packer_.scene.objects.size(), 0);
        for (const Instance& i : packer_.scene.instances) ++uses_[static_cast<size_t>(i.object)];
    }

    /// An object's hierarchy has a space of its own, for the same reason as the scene.
    void addObject(Group& group, const Object& object) {
        Box box;
        for (const Shape& s : object.shapes) box.grow(boundsOf(s, s.worldFromObject));
        group.groupFromWorld = spaceOf(box).sceneFromWorld();
        for (const Shape& s : object.shapes) addShape(group, s, s.worldFromObject, true, false);
    }

    /// A copy of an object; one that is used only once becomes part of the world.
    void addInstance(Group& world, const Instance& i) {
        const Object& object = packer_.scene.objects[static_cast<size_t>(i.object)];
        if (uses_[static_cast<size_t>(i.object)] == 1) {
            for (const Shape& s : object.shapes) addShape(world, s, i.worldFromObject * s.worldFromObject, true, swapsHandedness(i.worldFromObject));
        } else instances_.push_back(&i);
    }

    void addShape(Group& group, const Shape& s, const glm::dmat4& worldFromObject, bool inObject, bool instanceSwaps) {
        const uint materialIndex = packedMaterial(packer_, s.material);
        const bool isInterface = tables_.materials[materialIndex].hop == hop_passage;
        const bool emits = s.areaLight != none && !inObject;
        if (s.areaLight != none && inObject)
            packer_.diagnostics.unsupported("area light in object", s.where, "area lights in instanced objects do not emit (as in pbrt-v4)");
        if (isInterface && !emits && !packer_.hasMedia) return;

        shape packed{};
        packed.material = materialIndex;
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
        const glm::dmat4 groupFromObject = group.groupFromWorld * worldFromObject;
        const size_t elements = std::visit(Overloaded{
            [&](const TriangleMesh& m) { return addTriangles(group, packed, s, *m.mesh, groupFromObject); },
            [&](const BilinearMesh& m) { return addPatches(group, packed, s, *m.mesh, groupFromObject); },
            [&](const Sphere& q) { return addSphere(group, packed, s, q, groupFromObject, instanceSwaps); },
            [&](const Disk& q) { return addDisk(group, packed, s, q, groupFromObject, instanceSwaps); }}, s.kind);
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
        ++packer_.packed.counts.quadrics;
        return 1;
    }

    static float radians(double degrees) { return static_cast<float>(glm::radians(std::clamp(degrees, 0.0, 360.0))); }

    size_t addSphere(Group& group, shape& packed, const Shape& s, const Sphere& sphere, const glm::dmat4& m, bool instanceSwaps) {
        packed.kind = shape_sphere;
        packer_.packed.require(Feature::SHAPE_SPHERE, s.where.toString());
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
        quadric q{};
        q.radius = static_cast<float>(disk.radius);
        q.inner_radius = static_cast<float>(disk.innerRadius);
        q.z_min = q.z_max = static_cast<float>(disk.height);
        q.phi_max = radians(disk.phiMax);
        return addQuadric(group, packed, s, q, m, instanceSwaps);
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
    void buildHierarchies(Group& world, const std::vector<Group>& objects) {
        const auto start = std::chrono::steady_clock::now();
        BvhTables bvh;
        std::vector<BvhRoot> roots(objects.size());
        for (size_t i = 0; i < objects.size(); ++i)
            if (!objects[i].triangles.empty() || !objects[i].boxed.empty()) roots[i] = build(bvh, objects[i]);
        for (const Instance* i : instances_) placeInstance(world, *i, objects[static_cast<size_t>(i->object)], roots[static_cast<size_t>(i->object)]);
        const BvhRoot root = build(bvh, world, true);
        tables_.nodes = std::move(bvh.nodes);
        tables_.triangle_blocks = std::move(bvh.triangleBlocks);
        tables_.leaf_elements = std::move(bvh.leafElements);
        packer_.packed.counts.bvhDepth = root.depth;
        packer_.packed.counts.buildSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    void placeInstance(Group& world, const Instance& i, const Group& object, const BvhRoot& root) {
        if (object.triangles.empty() && object.boxed.empty()) return;
        const glm::dmat4 sceneFromObject = world.groupFromWorld * i.worldFromObject * glm::inverse(object.groupFromWorld);
        Box box;
        for (int c = 0; c < 8; ++c)
            box.grow(transformPoint(sceneFromObject, {c & 1 ? root.high.x : root.low.x, c & 2 ? root.high.y : root.low.y, c & 4 ? root.high.z : root.low.z}));
        addBox(world, box, static_cast<uint>(tables_.instances.size()), leaf_instances);
        tables_.instances.push_back({toAffine(glm::inverse(sceneFromObject)), toAffine(sceneFromObject), root.root});
        packer_.packed.require(Feature::INSTANCES, i.where.toString());
    }

    Packer& packer_;
    SceneTables& tables_;
    std::vector<int> uses_;
    std::vector<const Instance*> instances_;
};

void packGeometry(Packer& packer) { GeometryPacker(packer).pack(); }

}  // namespace eikonal
