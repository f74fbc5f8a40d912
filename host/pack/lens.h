#pragma once
// The lens of a realistic camera: rays through its elements, in double precision, to focus it and to find its exit pupil
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

class LensSystem {
public:
    /// Of a realistic camera with a film of that diagonal (millimetres), focused. The stop is made as wide as the camera wants; if its lens
    /// has no room for that, as wide as it can be (stopIsTooWide). Throws SceneError at camera.where: the lens cannot be focused there, or
    /// lets nothing pass.
    LensSystem(const CameraDescription& camera, double filmDiagonal);

    /// A ray from the film to the scene; nothing if it is blocked. A stop with a shape counts as a square.
    std::optional<LensRay> fromFilm(LensRay ray) const;
    /// And the other way round.
    std::optional<LensRay> fromScene(LensRay ray) const;

    /// Where, on the plane of the element next to the film, light comes from that reaches points of the film from `near` to `far` of its
    /// centre, on the x axis. Empty if none does.
    pupil_bounds pupil(double near, double far) const;
    /// All PUPIL_INTERVALS of them.
    Table<pupil_bounds> pupils() const;

    /// Elements as the device passes them.
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

/// What a stop with a shape lets pass, row by row from the bottom, scaled to a mean of pi / 4: as bright as a round one.
struct ApertureTexels { int width = 0, height = 0; Table<float> values; };
struct ImageData;
/// `image` is only read for ApertureShape::image. A round one has no texels. Throws Error if nothing passes.
ApertureTexels apertureTexels(ApertureShape shape, const ImageData* image);

}  // namespace eikonal
