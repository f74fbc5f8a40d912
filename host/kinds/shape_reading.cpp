#include "kinds/shape_reading.h"

#include <algorithm>

namespace eikonal::pbrt {

double phiMaxOf(const Arguments& arguments) { return std::clamp(arguments.number("phimax"), 0., 360.); }

bool keepIf(bool hasArea, const ShapeReading& in) {
    if (!hasArea)
        in.reading.diagnostics.warn(in.arguments.where(),
                                    in.arguments.kind().title() + " has zero area (radii and ranges); it is skipped");
    return hasArea;
}

}  // namespace eikonal::pbrt
