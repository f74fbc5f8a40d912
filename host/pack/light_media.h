#pragma once
// Which medium is around a light, where light paths begin.

#include "pack/space.h"
#include "scene/scene.h"

#include <optional>
#include <vector>

namespace eikonal {

/// A scene says which medium the camera is in, and which are on both sides of a boundary: paths from the camera learn their medium on the
/// way. Light paths must agree with them, so the medium at a point is that of the nearest boundary on the way to the camera, on the side of
/// the point; with none, that of the camera.
class LightMedia {
public:
    /// Keeps the scene.
    explicit LightMedia(const Scene&);
    /// At a point in world space: a medium in Scene::media, or `none` for vacuum. Nothing if it cannot be told: there may be a boundary in
    /// between that is a part of a sphere, a curved shape, in an object, or moving.
    /// except: a shape of the scene that does not count.
    std::optional<int> at(glm::dvec3 p, const Shape* except = nullptr) const;
    /// Around the scene.
    std::optional<int> outside() const;
    /// Whether a point in world space is, or may be, inside a subsurface body. It may be in the box of a body whose inside cannot be told.
    bool mayBeInBody(glm::dvec3 p) const;
    /// Whether the material of a shape is that of a subsurface body, or a mix with one.
    bool isBody(const Shape& s) const;

    /// A boundary that says, of its side towards the camera, that another medium is there than paths from the camera come through.
    struct Contradiction { const Shape* boundary; int said, found; };
    /// The first of them, if some points of each mesh and sphere show one. There paths from both ends cannot agree.
    std::optional<Contradiction> contradiction() const;

private:
    /// The same, with the boundary that tells; null: the camera's medium.
    struct Told { int medium; const Shape* by; };
    std::optional<Told> tell(glm::dvec3 p, const Shape* except) const;
    std::optional<Contradiction> contradictionAt(const Shape& s, glm::dvec3 p) const;
    bool isSeeThrough(const Shape& s) const;

    std::vector<bool> ofBody_;    ///< by material
    std::vector<const Shape*> boundaries_;
    std::vector<Box> boxes_;      ///< of boundaries_
    std::vector<Box> untold_;     ///< of the other boundaries
    std::vector<const Shape*> bodies_;   ///< subsurface bodies of which it can be told whether a point is inside
    std::vector<Box> bodyBoxes_;         ///< of bodies_
    std::vector<Box> untoldBodies_;      ///< of the others
    glm::dvec3 eye_;
    int aroundCamera_;
    const Scene& scene_;
    mutable double testsLeft_ = 5e7;   ///< of a triangle or sphere; a few seconds. Then nothing can be told
};

}  // namespace eikonal
