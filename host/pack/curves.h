#pragma once
// Curves as the device sees them: segments, cut into parts that are short and straight enough.

#include "scene/shapes.h"
#include "eikonal/shape.h"
#include "pack/space.h"

namespace eikonal {

/// Each segment of a curve becomes 2^curveSplits elements: as many as the scene asks for, and so many that an eighth of one is straight
/// but for a twentieth of its width (the criterion of pbrt-v4).
uint curveSplits(const Curve& curve);

/// A segment in the space that `m`, which keeps angles and handedness, takes its object space to; `scale` is that of m.
curve packSegment(const CurveSegment& segment, curve_type type, const glm::dmat4& m, double scale);

/// Bounds of one of the 2^splits parts, in the space of its control points.
Box boundsOfPart(const curve& c, uint part, uint splits);

}  // namespace eikonal
