// Triangle mesh, which may emit (kernels/shape/triangle.clh, kernels/light/triangle.clh).

#include "kinds/shape_packing.h"
#include "kinds/shape_reading.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

static bool readTriangles(const pbrt::ShapeReading& in, pbrt::PendingShape& pending) {
    pending.shape.mesh = pbrt::readMesh(in.reading, in.arguments, 3);
    return true;
}

static bool readSubdivided(const pbrt::ShapeReading& in, pbrt::PendingShape& pending) {
    pending.shape.mesh = pbrt::readSubdividedMesh(in.reading, in.arguments);
    return true;
}

/// Once the file is read, faces with four corners become bilinear patches (read/pbrt/shapes.cpp).
static bool readPly(const pbrt::ShapeReading& in, pbrt::PendingShape& pending) {
    if (!in.arguments.has("filename")) throw SceneError(in.arguments.where(), "shape \"plymesh\" needs a \"string filename\"");
    const std::optional<std::string> path = in.arguments.file("filename", "the shape is left out");
    if (!path) return false;
    pending.plyFile = in.plyFiles.add(*path, in.arguments.whereOf("filename"));
    if (const pbrt::Parameter* displacement = in.arguments.given("displacement")) {
        pending.displacement = *displacement;
        pending.shape.displacement = {none, in.arguments.number("edgelength") * in.reading.displacementEdgeScale, displacement->where};
    }
    return true;
}

static size_t pack(const ShapePacking& in) {
    if (in.description.displacement) throw std::logic_error("meshes must be displaced before they are packed (render/displacement.h)");
    const size_t count = in.description.mesh->indices.size() / 3;
    if (count == 0) return 0;
    addVertices(in);
    in.group.triangles.push_back({in.packed.first_vertex, in.packed.first_index, count, in.packed.first_element});
    in.counts.triangles += count;
    return count;
}

static light_kind lightKindOf(const Shape&, const glm::dmat4&) { return kind_triangle_light; }

static light packLight(const AreaElement& e, const color& L) {
    const uint* corner = &e.tables.indices[e.packed.first_index + 3 * e.element];
    const vec3* p = &e.tables.positions[e.packed.first_vertex];
    const glm::dvec3 a = toGlm(p[corner[0]]), b = toGlm(p[corner[1]]), c = toGlm(p[corner[2]]);
    const glm::dvec3 across = glm::cross(b - a, c - a);
    const double area = glm::length(across) / 2;
    light l = newLight(kind_triangle_light, L);
    l.p = toVec3(a); l.a = toVec3(b - a); l.b = toVec3(c - a);
    if (area > 0) {
        const int side = emittingSide(e, corner, {{across, {1, 0, 0}}, {across, {0, 1, 0}}, {across, {0, 0, 1}}});
        l.n = toVec3(across / (2 * area) * (side < 0 ? -1.0 : 1.0));
        l.inverse_area = static_cast<float>(1 / area);
        l.two_sided = side == 0;
    } else l.pmf = 0;
    return l;
}

static void boundLight(const light& l, double, LightBounds& bounds) {
    const glm::dvec3 p = toGlm(l.p), x = toGlm(l.a), y = toGlm(l.b);
    bounds.box.grow(p + x);
    bounds.box.grow(p + y);
}

const LightTraits triangle_light{.packElement = packLight, .bound = boundLight};

static const ShapeDirective directives[] = {
    {"trianglemesh", "integers indices; point3s P; normals N; vector3s S; point2s uv; integers faceIndices", readTriangles},
    {"plymesh", "file filename; floattexture displacement; float edgelength = 1 in (0, inf)", readPly},
    {"loopsubdiv", "integers indices; point3s P; integer levels = 3 clamped to [0, inf); string scheme = loop in {loop}", readSubdivided},
};

const ShapeTraits triangle_shape{.directives = directives, .corners = 3, .bound = meshBounds, .pack = pack, .lightKindOf = lightKindOf};

}  // namespace eikonal
