// Mesh of bilinear patches, which may emit (kernels/shape/bilinear.clh, kernels/light/bilinear.clh).

#include "kinds/shape_packing.h"
#include "kinds/shape_reading.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eikonal {

static bool read(const pbrt::ShapeReading& in, pbrt::PendingShape& pending) {
    pending.shape.mesh = pbrt::readMesh(in.reading, in.arguments, 4);
    if (in.arguments.file("emissionfilename")) in.reading.diagnostics.info("\"emissionfilename\" only guides sampling; it is not used");
    return true;
}

static size_t pack(const ShapePacking& in) {
    const Mesh& mesh = *in.description.mesh;
    const size_t count = mesh.indices.size() / 4;
    if (count == 0) return 0;
    addVertices(in);
    for (size_t i = 0; i < count; ++i) {
        Box box;
        for (int c = 0; c < 4; ++c)
            box.grow(toGlm(in.tables.positions[in.packed.first_vertex + mesh.indices[4 * i + static_cast<size_t>(c)]]));
        addBox(in.group, box, in.packed.first_element + static_cast<uint>(i));
    }
    in.counts.patches += count;
    return count;
}

static light_kind lightKindOf(const Shape&, const glm::dmat4&) { return kind_bilinear_light; }

static light packLight(const AreaElement& e, const color& L) {
    const uint* corner = &e.tables.indices[e.packed.first_index + 4 * e.element];
    const vec3* p = &e.tables.positions[e.packed.first_vertex];
    const glm::dvec3 p00 = toGlm(p[corner[0]]), p10 = toGlm(p[corner[1]]), p01 = toGlm(p[corner[2]]), p11 = toGlm(p[corner[3]]);
    light l = newLight(kind_bilinear_light, L);
    l.p = toVec3(p00); l.a = toVec3(p10 - p00); l.b = toVec3(p01 - p00); l.c = toVec3(p11 - p10 - p01 + p00);
    glm::dvec3 n = glm::cross(p10 + p11 - p00 - p01, p01 + p11 - p00 - p10);
    /* Integrate the area numerically; the light sampler's probability needs it */
    double area = 0;
    std::vector<MeshPoint> points;
    constexpr int steps = 16;
    for (int i = 0; i < steps * steps; ++i) {
        const double u = (i % steps + 0.5) / steps, v = (i / steps + 0.5) / steps;
        points.push_back({glm::cross(toGlm(l.a) + v * toGlm(l.c), toGlm(l.b) + u * toGlm(l.c)),
                          {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v}});
        area += glm::length(points.back().across) / (steps * steps);
    }
    if (area > 0) {
        const int side = emittingSide(e, corner, points);
        l.extent = side < 0 ? -1.0f : 1.0f;
        l.n = toVec3(glm::length(n) > 0 ? glm::normalize(n) * static_cast<double>(l.extent) : glm::dvec3(0, 0, 1));
        l.inverse_area = static_cast<float>(1 / area);
        l.two_sided = side == 0;
    } else l.pmf = 0;
    return l;
}

static void boundLight(const light& l, double, LightBounds& bounds) {
    const glm::dvec3 p = toGlm(l.p), x = toGlm(l.a), y = toGlm(l.b);
    /* The normals at the corners bound all normals, which are bilinear. Of a patch that folds, they point to both sides */
    const glm::dvec3 c = toGlm(l.c);
    for (int i = 0; i < 4; ++i) {
        const double u = i & 1, v = i >> 1;
        bounds.box.grow(p + u * x + v * y + u * v * c);
        const glm::dvec3 n = glm::cross(x + v * c, y + u * c);
        const double length = glm::length(n);
        if (length > 0) bounds.normals = std::max(bounds.normals, angleBetween(n / length * static_cast<double>(l.extent), bounds.axis));
    }
    if (bounds.normals > std::numbers::pi / 4) boundAllDirections(bounds);
}

const LightTraits bilinear_light{.packElement = packLight, .bound = boundLight};

static const ShapeDirective directives[] = {
    {"bilinearmesh", "integers indices; point3s P; normals N; point2s uv; integers faceIndices; file emissionfilename", read},
};

const ShapeTraits bilinear_shape{.directives = directives, .corners = 4, .bound = meshBounds, .pack = pack, .lightKindOf = lightKindOf};

}  // namespace eikonal
