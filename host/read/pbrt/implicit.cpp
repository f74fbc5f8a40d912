#include "read/pbrt/implicit.h"

#include "read/formats/expression.h"

#include <fmt/format.h>

namespace eikonal::pbrt {

/// Details smaller than this, relative to the largest coordinate of the box, are lost (IMPLICIT_RESOLUTION, kernels/shape/implicit.clh).
constexpr double resolution = 0x1p-21;
/// A box at least this many times as far from the origin as it is large is worth a warning.
constexpr double farAway = 32;

static void warnOfDistance(Reading& reading, const SourceLocation& where, const ImplicitSurface& surface) {
    const glm::dvec3 reach = glm::max(glm::abs(surface.low), glm::abs(surface.high)), size = surface.high - surface.low;
    const double largest = std::max({reach.x, reach.y, reach.z}), longest = std::max({size.x, size.y, size.z});
    if (largest >= farAway * longest)
        reading.diagnostics.warn(where, fmt::format("the box is {:.0f} times as far from the origin as it is large: details smaller than "
                                                    "{:.1g} are lost; write F near the origin and move the shape by a transform",
                                                    largest / longest, largest * resolution));
}

ImplicitSurface readImplicit(Reading& reading, const Arguments& arguments) {
    const std::string title = arguments.kind().title();
    if (!arguments.has("F")) throw SceneError(arguments.where(), title + " needs its function, as in \"string F\" \"x^2 + y^2 + z^2 - 1\"");
    std::map<std::string, double> constants;
    for (const char* name : {"a", "b", "c", "d"})
        if (arguments.has(name)) constants[name] = arguments.number(name);
    ImplicitSurface surface;
    const std::string text = arguments.text("F");
    surface.F = std::make_shared<const Expression>(readExpression(text, arguments.given("F")->whereText, constants));

    const std::vector<glm::dvec3> corners = arguments.points3("bounds");
    if (corners.size() != 2)
        throw SceneError(arguments.whereOf("bounds"),
                         title + " needs a box that bounds it, given by two corners, as in \"point3 bounds\" [-1 -1 -1  1 1 1]");
    surface.low = glm::min(corners[0], corners[1]);
    surface.high = glm::max(corners[0], corners[1]);
    for (int c = 0; c < 3; ++c)
        if (!(surface.low[c] < surface.high[c]))
            throw SceneError(arguments.whereOf("bounds"),
                             "\"point3 bounds\" is a box without volume: both corners have the same " + std::string(1, "xyz"[c]));
    warnOfDistance(reading, arguments.whereOf("bounds"), surface);
    return surface;
}

}  // namespace eikonal::pbrt
