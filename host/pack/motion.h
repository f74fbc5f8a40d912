#pragma once
// Motion between two transforms, interpolated as in include/eikonal/motion.h.

#include "scene/scene.h"
#include "eikonal/motion.h"
#include "pack/space.h"

#include <vector>

namespace eikonal {

/// A transform, decomposed: stretch, then rotation, then translation. The rotation is proper; a reflection is part of the stretch.
struct Decomposition {
    glm::dvec3 translation{0};
    glm::dmat3 rotation{1}, stretch{1};
};
/// The polar decomposition of an invertible transform (Higham 1986).
Decomposition decompose(const glm::dmat4& m);

/// A time interval of the motion, which lasts from 0 to 1.
struct TimeSpan { double from = 0, to = 1; };

/// A motion in double precision.
class Motion {
public:
    /// From one invertible transform to another; the same twice for something static.
    Motion(const glm::dmat4& start, const glm::dmat4& end);

    /// The transform at a time in [0, 1].
    glm::dmat4 at(double time) const;
    /// Conservative bounds of a moving box in a time interval; tight if the rotation in it is small.
    Box bounds(const Box& box, TimeSpan span) const;
    /// The motion for the device, from the space `inner` of what moves to the space `outer` of what surrounds it.
    motion pack(const SceneSpace& outer, const SceneSpace& inner) const;

private:
    Decomposition start_, end_;
    glm::dvec4 startRotation_, endRotation_;   ///< quaternions, x y z w
    double angle_;                             ///< between the quaternions, in [0, pi / 2]
};

/// Conservative bounds of a box under nested motions, outermost first; tight to about 0.1 %.
Box boundsInMotion(const std::vector<Motion>& motions, const Box& box, TimeSpan span);

/// Whether anything but the camera moves: shapes, instances or media.
bool hasMovingParts(const Scene& scene);

/// Whether a transform can be inverted.
bool isInvertible(const glm::dmat4& m);

/// The time interval in which the shutter is open.
TimeSpan timesSeen(const Scene& scene);
/// The same for the device.
shutter shutterOf(const Scene& scene);

}  // namespace eikonal
