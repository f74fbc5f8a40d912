#include "read/pbrt/curves.h"

#include "read/mesh/origin.h"

#include <algorithm>
#include <cmath>

namespace eikonal::pbrt {
namespace {

using Points = std::array<glm::vec3, 4>;

/// Degree elevation from 2 to 3.
Points elevated(glm::vec3 a, glm::vec3 b, glm::vec3 c) { return {a, glm::mix(a, b, 2.f / 3), glm::mix(b, c, 1.f / 3), c}; }

/// The Bezier points of a segment of a uniform B-spline, by its blossom.
Points bezierOfSpline(const glm::vec3* p, int degree) {
    if (degree == 2) return elevated(glm::mix(p[0], p[1], .5f), p[1], glm::mix(p[1], p[2], .5f));
    const glm::vec3 b = glm::mix(p[1], p[2], 1.f / 3), c = glm::mix(p[1], p[2], 2.f / 3);
    return {glm::mix(glm::mix(p[0], p[1], 2.f / 3), b, .5f), b, c, glm::mix(c, glm::mix(p[2], p[3], 1.f / 3), .5f)};
}

curve_type typeOf(const Arguments& arguments) {
    const std::string type = arguments.text("type");
    return type == "flat" ? curve_flat : type == "ribbon" ? curve_ribbon : curve_cylinder;
}

/// The number of segments of the control points. Throws SceneError if they do not fit.
size_t countSegments(const Arguments& arguments, size_t points, const std::string& basis, int degree) {
    const auto d = static_cast<size_t>(degree);
    const std::string title = arguments.kind().title();
    const std::string found = title + " has " + std::to_string(points) + " control points; of degree " + std::to_string(degree) +
                              " in the basis \"" + basis + "\" it has ";
    if (basis == "bspline") {
        if (points < d + 1) throw SceneError(arguments.whereOf("P"), found + std::to_string(d + 1) + " or more");
        return points - d;
    }
    if (points < d + 1 || (points - 1) % d)
        throw SceneError(arguments.whereOf("P"),
                         found + std::to_string(d + 1) + ", and " + std::to_string(degree) + " for each further segment");
    return (points - 1) / d;
}

}  // namespace

std::shared_ptr<Curve> readCurve(Reading& reading, const Arguments& arguments) {
    const std::string title = arguments.kind().title(), basis = arguments.text("basis");
    const int degree = arguments.integer("degree");
    if (!arguments.has("P")) throw SceneError(arguments.where(), title + " needs its control points, \"point3 P\"");
    const std::vector<glm::dvec3> given = arguments.points3("P");
    const glm::dvec3 origin = originOf(given);
    const std::vector<glm::vec3> points = positionsFrom(origin, given);
    const size_t count = countSegments(arguments, points.size(), basis, degree);

    auto curve = std::make_shared<Curve>();
    curve->origin = origin;
    curve->type = typeOf(arguments);
    curve->splitDepth = arguments.integer("splitdepth");
    std::vector<glm::vec3> normals = arguments.vectors3("N");
    if (curve->type == curve_ribbon && normals.size() != count + 1)
        throw SceneError(arguments.whereOf("N"), title + " of type \"ribbon\" needs \"normal N\" at both ends of each segment: " +
                                                     std::to_string(count + 1) + " normals, not " + std::to_string(normals.size()));
    if (curve->type != curve_ribbon && !normals.empty())
        reading.diagnostics.warn(arguments.whereOf("N"), "only curves of type \"ribbon\" have normals; \"normal N\" is ignored");
    normals.resize(count + 1);

    const auto widthOf = [&](const char* end) { return arguments.has(end) ? arguments.number(end) : arguments.number("width"); };
    const double width0 = widthOf("width0"), width1 = widthOf("width1");
    if (width0 == 0 && width1 == 0)
        reading.unsupported("curve without width", arguments.whereOf(arguments.has("width0") ? "width0" : "width"),
                            title + " has a width of 0, so it is not seen");
    const auto widthAt = [&](size_t i) { return std::abs(glm::mix(width0, width1, static_cast<double>(i) / static_cast<double>(count))); };
    for (size_t i = 0; i < count; ++i) {
        const glm::vec3* p = &points[basis == "bspline" ? i : i * static_cast<size_t>(degree)];
        CurveSegment segment;
        if (basis == "bspline") segment.points = bezierOfSpline(p, degree);
        else segment.points = degree == 2 ? elevated(p[0], p[1], p[2]) : Points{p[0], p[1], p[2], p[3]};
        segment.width = {widthAt(i), widthAt(i + 1)};
        segment.normals = {normals[i], normals[i + 1]};
        curve->segments.push_back(segment);
    }
    return curve;
}

}  // namespace eikonal::pbrt
