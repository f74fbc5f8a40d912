#include "kinds/shape_packing.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

/// Appends a mesh's normals or tangents, transformed by `m` and scaled by one common factor so that the longest has unit length: what is
/// interpolated between them has the direction that the transform gives to what was interpolated before. None becomes so short that its
/// square is 0 in single precision.
static void addVectors(Table<vec3>& result, const std::vector<glm::vec3>& vectors, const glm::dmat3& m) {
    constexpr double shortest = 1e-15;
    double longest = 0;
    for (const glm::vec3& v : vectors) longest = std::max(longest, glm::length(m * glm::dvec3(v)));
    for (const glm::vec3& v : vectors) {
        const glm::dvec3 transformed = m * glm::dvec3(v);
        const double length = glm::length(transformed);
        result.push_back(toVec3(length > 0 ? transformed / length * std::max(length / longest, shortest) : glm::dvec3(0)));
    }
}

void addVertices(const ShapePacking& in) {
    const auto& [context, tables, counts, group, s, packed, m, instanceSwaps] = in;
    const Mesh& mesh = *s.mesh;
    packed.first_vertex = static_cast<uint>(tables.positions.size());
    packed.first_index = static_cast<uint>(tables.indices.size());
    if (s.reverseOrientation != swapsHandedness(m)) packed.flags |= shape_reversed;
    const glm::dmat4 placed = fromPositions(m, mesh.origin);
    for (const glm::vec3& p : mesh.positions) tables.positions.push_back(toVec3(transformPoint(placed, p)));
    tables.indices.insert(tables.indices.end(), mesh.indices.begin(), mesh.indices.end());
    if (!mesh.normals.empty()) {
        packed.first_normal = static_cast<uint>(tables.normals.size());
        addVectors(tables.normals, mesh.normals, normalTransform(m) * (s.reverseOrientation ? -1.0 : 1.0));
    }
    if (!mesh.tangents.empty()) {
        packed.first_tangent = static_cast<uint>(tables.tangents.size());
        addVectors(tables.tangents, mesh.tangents, glm::dmat3(m));
        context.require(Feature::TANGENTS, s.where.toString());
    }
    if (!mesh.uvs.empty()) {
        packed.first_uv = static_cast<uint>(tables.uvs.size());
        for (const glm::vec2& uv : mesh.uvs) tables.uvs.push_back({uv.x, uv.y});
    }
}

/// addInObjectSpace with the map from object space to the space of the group.
static size_t addWithMap(const ShapePacking& in, object_space q, bool flips, const glm::dmat4& sceneFromObject) {
    if (in.description.reverseOrientation != flips) in.packed.flags |= shape_reversed;
    in.packed.object_space = static_cast<uint>(in.tables.object_spaces.size());
    q.scene_from_object = toAffine(sceneFromObject);
    q.object_from_scene = toAffine(glm::inverse(sceneFromObject));
    in.tables.object_spaces.push_back(q);
    addBox(in.group, in.description.kind->traits.bound(in.description, in.m), in.packed.first_element);
    return 1;
}

size_t addInObjectSpace(const ShapePacking& in, object_space q, bool flips) { return addWithMap(in, q, flips, in.m); }

size_t addRound(const ShapePacking& in, object_space q, int curved) {
    const double unit = unitOfRound(in);
    glm::dmat4 linear = in.m * scaling(unit);
    const glm::dvec3 placed = linear[3];
    linear[3] = {0, 0, 0, 1};
    glm::dvec3 center = transformVector(glm::inverse(linear), placed);
    const double radius = in.description.radius / unit;
    if (curved == 0) {
        q.z_min = q.z_max = static_cast<float>(center.z + in.description.height / unit);
    } else {
        double square = 0;
        for (int axis = 0; axis < curved; ++axis) square += center[axis] * center[axis];
        /* A surface with a larger power is far from the origin, where the power is not used */
        q.power = static_cast<float>(std::min(square - radius * radius, 1e30));
    }
    q.center = toVec3(center);
    return addWithMap(in, q, isMirrored(in), linear);
}

double unitOfRound(const ShapePacking& in) { return std::ldexp(1.0, std::ilogb(in.description.radius)); }

object_space newRound(const ShapePacking& in) {
    ++in.counts.quadrics;
    object_space q{};
    q.radius = static_cast<float>(in.description.radius / unitOfRound(in));
    q.phi_max = static_cast<float>(glm::radians(std::clamp(in.description.phiMax, 0.0, 360.0)));
    return q;
}

Box meshBounds(const Shape& s, const glm::dmat4& m) {
    Box box;
    const glm::dmat4 placed = fromPositions(m, s.mesh->origin);
    for (const glm::vec3& p : s.mesh->positions) box.grow(transformPoint(placed, p));
    return box;
}

}  // namespace eikonal
