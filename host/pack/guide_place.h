#pragma once
// Which part of a guide a surface belongs to, as kernels/light/guide_place.clh on the device.

#include "eikonal/portable.h"

#include <cmath>
#include <cstddef>

namespace eikonal {

/// axis: 0, 1 or 2.
inline float coordinate(const vec3& p, size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// The face of a guide (GUIDE_FACES) for surfaces with the normal n, which must not be zero: of +x, -x, +y, -y, +z, -z the nearest to it.
inline size_t guideFace(const vec3& n) {
    const float x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
    return z >= x && z >= y ? (n.z < 0 ? 5 : 4) : x >= y ? (n.x < 0 ? 1 : 0) : (n.y < 0 ? 3 : 2);
}

}  // namespace eikonal
