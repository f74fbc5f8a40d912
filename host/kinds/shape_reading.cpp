#include "kinds/shape_reading.h"

namespace eikonal::pbrt {

bool keepIf(bool hasArea, const ShapeReading& in) {
    if (!hasArea)
        in.reading.diagnostics.warn(in.arguments.where(),
                                    in.arguments.kind().title() + " has zero area (radii and ranges); it is skipped");
    return hasArea;
}

}  // namespace eikonal::pbrt
