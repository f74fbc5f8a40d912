// Curves (kernels/shape/curve.clh).

#include "kinds/shape_packing.h"
#include "kinds/shape_reading.h"
#include "pack/curves.h"
#include "read/pbrt/curves.h"

#include <algorithm>

namespace eikonal {

static bool read(const pbrt::ShapeReading& in, pbrt::PendingShape& pending) {
    pending.shape.curve = pbrt::readCurve(in.reading, in.arguments);
    return true;
}

static Box bound(const Shape& s, const glm::dmat4& m) {
    Box box;
    const glm::dmat4 placed = fromPositions(m, s.curve->origin);
    for (const CurveSegment& segment : s.curve->segments) {
        const double half = 0.5 * std::max(segment.width[0], segment.width[1]);
        for (const glm::dvec3 p : segment.points) box.grow(transformed({p - half, p + half}, placed));
    }
    return box;
}

/// Packs the curve in the hierarchy's space if m is a similarity without mirroring; otherwise packs it in object space with transforms,
/// which the kernel applies to each ray.
static size_t pack(const ShapePacking& in) {
    const Curve& description = *in.description.curve;
    const glm::dmat4 m = fromPositions(in.m, description.origin);
    GeometryTables& tables = in.tables;
    in.context.require(Feature::STRIPS, in.description.where.toString());
    if (in.description.reverseOrientation != isMirrored(in)) in.packed.flags |= shape_reversed;
    in.packed.flags |= shape_faces_rays;
    in.packed.first_index = static_cast<uint>(tables.curve_segments.size());
    in.packed.splits = curveSplits(description);
    const double scale = swapsHandedness(m) ? 0 : uniformScale(m);
    if (scale == 0) {
        in.packed.object_space = static_cast<uint>(tables.object_spaces.size());
        object_space maps{};
        maps.scene_from_object = toAffine(m);
        maps.object_from_scene = toAffine(glm::inverse(m));
        tables.object_spaces.push_back(maps);
    }
    const uint parts = 1u << in.packed.splits;
    uint element = in.packed.first_element;
    for (const CurveSegment& segment : description.segments) {
        const curve c = packSegment(segment, description.type, scale > 0 ? m : glm::dmat4(1), scale > 0 ? scale : 1);
        tables.curve_segments.push_back(c);
        for (uint part = 0; part < parts; ++part, ++element) {
            if (c.width[0] <= 0 && c.width[1] <= 0) continue;
            const Box box = boundsOfPart(c, part, in.packed.splits);
            addBox(in.group, scale > 0 ? box : transformed(box, m), element);
        }
    }
    in.counts.curves += description.segments.size();
    return element - in.packed.first_element;
}

static const ShapeDirective directives[] = {
    {"curve",
     "point3s P; integer degree = 3 in [2, 3]; string basis = bezier in {bezier, bspline};"
     "string type = flat in {flat, cylinder, ribbon}; normals N; float width = 1; float width0; float width1;"
     "integer splitdepth = 3",
     read},
};

const ShapeTraits curve_shape{
    .directives = directives, .bound = bound, .pack = pack, .cannotEmit = "a curve cannot emit (pbrt-v4 stops there)"};

}  // namespace eikonal
