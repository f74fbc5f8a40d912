#pragma once
// The lens of a realistic camera: traces rays through its elements in double precision, to focus it and to find its exit pupil
// (Kolb et al. 1995; Pharr et al. 2016, section 6.4). The film lies at z = 0 and looks along +z; metres.

#include "eikonal/camera.h"
#include "memory_pages.h"
#include "error.h"
#include "scene/camera.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace eikonal {

struct LensRay { glm::dvec3 o, d; };
/// A disk perpendicular to the axis.
struct LensDisk { double z, radius; };

class LensSystem {
public:
    /// The lens of a realistic camera with a film of that diagonal (millimetres), focused. The stop has the camera's aperture diameter,
    /// clamped to the size of the lens's stop (stopIsTooWide). Throws SceneError at camera.where if the lens cannot be focused, or blocks
    /// all light.
    LensSystem(const CameraDescription& camera, double filmDiagonal);

    /// A ray from the film to the scene; nothing if it is blocked. A stop that is not round counts as a square.
    std::optional<LensRay> fromFilm(LensRay ray) const;
    /// The same in the other direction.
    std::optional<LensRay> fromScene(LensRay ray) const;

    /// The exit pupil, on the plane of the rear element, of the film points on the x axis from `near` to `far`. Empty if no light
    /// arrives there.
    pupil_bounds pupil(double near, double far) const;
    /// The exit pupils of all PUPIL_INTERVALS intervals.
    Table<pupil_bounds> pupils() const;

    /// A disk in front of the glass through which all rays leave, but a few at its edge and those that leave at more than 84 degrees to the
    /// axis. `pupils`: those of pupils().
    LensDisk front(const Table<pupil_bounds>& pupils) const;

    /// The elements in the device's format.
    Table<lens_element> elements() const;
    double rearZ() const { return elements_.front().z; }
    bool stopIsTooWide() const { return stopIsTooWide_; }

private:
    struct Element { double z, radius, aperture, eta; };   ///< as lens_element
    std::optional<LensRay> pass(const Element& e, double eta, LensRay ray) const;
    void focus(const CameraDescription& camera);

    std::vector<Element> elements_;   ///< from the film to the scene
    double filmRadius_;
    bool stopHasShape_, stopIsTooWide_ = false;
};

/// The transmission of a stop that is not round, row by row from the bottom, scaled to a mean of pi / 4, so that it is as bright as a
/// round one.
struct ApertureTexels { int width = 0, height = 0; Table<float> values; };
struct ImageData;
/// `image` is only read for ApertureShape::image. A round stop has no texels. Throws Error for a stop that blocks all light.
ApertureTexels apertureTexels(ApertureShape shape, const ImageData* image);

}  // namespace eikonal
