#include "pack/shapes.h"

#include "overloaded.h"
#include "pack/curves.h"
#include "pack/implicit.h"

#include <cmath>
#include <stdexcept>

namespace eikonal {

/// A mesh's tangents where `m` takes them, the longest of unit length: their squares are finite then, and means of theirs stay what they are.
static std::vector<glm::dvec3> tangentsInReach(const Mesh& mesh, const glm::dmat4& m) {
    std::vector<glm::dvec3> tangents;
    double longest = 0;
    for (const glm::vec3& t : mesh.tangents) {
        tangents.push_back(transformVector(m, t));
        longest = std::max(longest, glm::length(tangents.back()));
    }
    for (glm::dvec3& t : tangents) t *= longest > 0 ? 1 / longest : 0;
    return tangents;
}

class ShapePacker {
public:
    explicit ShapePacker(Packer& packer) : packer_(packer), tables_(packer.packed.tables) {}

    void add(Group& group, const Shape& s, const glm::dmat4& worldFromObject, bool inObject, bool instanceSwaps, uint id) {
        const uint materialIndex = packedMaterial(packer_, s.material);
        const bool isInterface = tables_.materials[materialIndex].next_queue == next_crossing;
        const bool emits = s.areaLight != none && !inObject && countsMaterials(packer_.scene.integrator);
        if (s.areaLight != none && inObject)
            packer_.diagnostics.unsupported("area light in object", s.where, "area lights in instanced objects do not emit (as in pbrt-v4)");
        if (isInterface && !emits && !packer_.hasMedia) return;

        shape packed{};
        packed.material = materialIndex;
        packed.id = id;
        packed.first_element = static_cast<uint>(tables_.element_shapes.size());
        packed.first_normal = packed.first_tangent = packed.first_uv = packed.quadric = packed.first_light = packed.alpha = packed.emission = NONE;
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
            [&](const TriangleMesh& m) {
                if (s.displacement) throw std::logic_error("a mesh is to be displaced before it is packed (render/displacement.h)");
                return addTriangles(group, packed, s, *m.mesh, groupFromObject);
            },
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

private:
    void addVertices(shape& packed, const Shape& s, const Mesh& mesh, const glm::dmat4& m) {
        packed.first_vertex = static_cast<uint>(tables_.positions.size());
        packed.first_index = static_cast<uint>(tables_.indices.size());
        if (s.reverseOrientation != swapsHandedness(m)) packed.flags |= shape_reversed;
        for (const glm::vec3& p : mesh.positions) tables_.positions.push_back(toVec3(transformPoint(m, p)));
        tables_.indices.insert(tables_.indices.end(), mesh.indices.begin(), mesh.indices.end());
        if (!mesh.normals.empty()) {
            packed.first_normal = static_cast<uint>(tables_.normals.size());
            for (const glm::vec3& n : mesh.normals) tables_.normals.push_back(toVec3(transformNormal(m, n) * (s.reverseOrientation ? -1.0 : 1.0)));
        }
        if (!mesh.tangents.empty()) {
            packed.first_tangent = static_cast<uint>(tables_.tangents.size());
            for (const glm::dvec3& t : tangentsInReach(mesh, m)) tables_.tangents.push_back(toVec3(t));
            packer_.packed.require(Feature::TANGENTS, s.where.toString());
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
        /* The normal is made in object space and transformed, so only the shape's own transform can flip it, as pbrt-v4's mirrored quadrics do;
           an implicit surface has its inside where F is negative, mirrored or not */
        if (s.reverseOrientation != (packed.kind != shape_implicit && swapsHandedness(m) != instanceSwaps)) packed.flags |= shape_reversed;
        packed.quadric = static_cast<uint>(tables_.quadrics.size());
        q.scene_from_object = toAffine(m);
        q.object_from_scene = toAffine(glm::inverse(m));
        tables_.quadrics.push_back(q);
        addBox(group, boundsOf(s, m), packed.first_element);
        return 1;
    }

    /// What spheres, disks and cylinders have in common. phiMax in degrees.
    quadric beginRound(shape& packed, const Shape& s, shape_kind kind, Feature feature, double radius, double phiMax) {
        packed.kind = kind;
        packer_.packed.require(feature, s.where.toString());
        ++packer_.packed.counts.quadrics;
        quadric q{};
        q.radius = static_cast<float>(radius);
        q.phi_max = static_cast<float>(glm::radians(std::clamp(phiMax, 0.0, 360.0)));
        return q;
    }

    size_t addSphere(Group& group, shape& packed, const Shape& s, const Sphere& sphere, const glm::dmat4& m, bool instanceSwaps) {
        quadric q = beginRound(packed, s, shape_sphere, Feature::SHAPE_SPHERE, sphere.radius, sphere.phiMax);
        q.z_min = static_cast<float>(std::clamp(std::min(sphere.zMin, sphere.zMax), -sphere.radius, sphere.radius));
        q.z_max = static_cast<float>(std::clamp(std::max(sphere.zMin, sphere.zMax), -sphere.radius, sphere.radius));
        return addQuadric(group, packed, s, q, m, instanceSwaps);
    }

    size_t addDisk(Group& group, shape& packed, const Shape& s, const Disk& disk, const glm::dmat4& m, bool instanceSwaps) {
        quadric q = beginRound(packed, s, shape_disk, Feature::SHAPE_DISK, disk.radius, disk.phiMax);
        q.inner_radius = static_cast<float>(disk.innerRadius);
        q.z_min = q.z_max = static_cast<float>(disk.height);
        return addQuadric(group, packed, s, q, m, instanceSwaps);
    }

    size_t addCylinder(Group& group, shape& packed, const Shape& s, const Cylinder& cylinder, const glm::dmat4& m, bool instanceSwaps) {
        quadric q = beginRound(packed, s, shape_cylinder, Feature::SHAPE_CYLINDER, cylinder.radius, cylinder.phiMax);
        q.z_min = static_cast<float>(cylinder.zMin);
        q.z_max = static_cast<float>(cylinder.zMax);
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

    Packer& packer_;
    SceneTables& tables_;
};

void packShape(Packer& packer, Group& group, const Shape& s, const glm::dmat4& worldFromObject, bool inObject, bool instanceSwaps, uint id) {
    ShapePacker(packer).add(group, s, worldFromObject, inObject, instanceSwaps, id);
}

}  // namespace eikonal
