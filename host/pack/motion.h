#pragma once
// Things that move: between two transforms, interpolated as include/eikonal/motion.h says.

#include "scene/scene.h"
#include "eikonal/motion.h"
#include "pack/space.h"

#include <vector>

namespace eikonal {

/// A map taken apart: m = rotation * stretch, then moved by translation. The rotation is proper; a mirroring is part of the stretch.
struct Decomposition {
    glm::dvec3 translation{0};
    glm::dmat3 rotation{1}, stretch{1};
};
/// The polar decomposition of a map that can be inverted (Higham 1986).
Decomposition decompose(const glm::dmat4& m);

/// A part of the motion's own time; 0 is its start, 1 its end.
struct TimeSpan { double from = 0, to = 1; };

/// A motion in double precision.
class Motion {
public:
    /// From one map to another, both of which can be inverted; the same twice for something that stands still.
    Motion(const glm::dmat4& start, const glm::dmat4& end);

    /// The map at a time in [0, 1].
    glm::dmat4 at(double time) const;
    /// What a box can reach within a span of time: bounds that hold, tight if nothing turns far in it.
    Box bounds(const Box& box, TimeSpan span) const;
    /// As the device interpolates it: from `inner`, into which its own space has been moved, to `outer`, into which the world has.
    motion pack(const SceneSpace& outer, const SceneSpace& inner) const;

private:
    Decomposition start_, end_;
    glm::dvec4 startRotation_, endRotation_;   ///< quaternions, x y z w
    double angle_;                             ///< between them, in [0, pi / 2]
};

/// What a box can reach under motions, one inside of the other, the outermost first: bounds that hold, tight to about a thousandth.
Box boundsInMotion(const std::vector<Motion>& motions, const Box& box, TimeSpan span);

/// Whether a transform can be inverted.
bool isInvertible(const glm::dmat4& m);

/// The part of all motion that the shutter sees.
TimeSpan timesSeen(const Scene& scene);
/// The same for the device.
shutter shutterOf(const Scene& scene);

}  // namespace eikonal
