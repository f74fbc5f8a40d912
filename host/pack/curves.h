#pragma once
// Curve segments for the device, split into parts that are short and straight enough.

#include "scene/shapes.h"
#include "eikonal/shape.h"
#include "pack/space.h"

namespace eikonal {

/// Each segment of a curve becomes 2^curveSplits elements: at least as many as the scene asks for, and enough that an eighth of an element
/// deviates from a line by at most a twentieth of its width (the criterion of pbrt-v4).
uint curveSplits(const Curve& curve);

/// A segment, transformed by `m`, which keeps angles and handedness and scales by `scale`.
curve packSegment(const CurveSegment& segment, curve_type type, const glm::dmat4& m, double scale);

/// Bounds of one of the 2^splits parts, in the space of its control points.
Box boundsOfPart(const curve& c, uint part, uint splits);

}  // namespace eikonal
