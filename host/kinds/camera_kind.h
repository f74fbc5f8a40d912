#pragma once
// The host's side of each kind of camera: one file in host/kinds/camera/ for each line of CAMERAS (include/eikonal/cameras.h).

#include "eikonal/camera.h"
#include "eikonal/cameras.h"
#include "feature_set.h"
#include "scene/camera.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>

namespace eikonal {

struct PackedScene;
struct CameraPacking;
namespace pbrt { struct CameraReading; }

/// What a kind's file defines. `parameters`, `pack` and `project` are required (tests/unit/kinds_test.cpp).
struct CameraTraits {
    /// Parameters of `Camera "name"` in a pbrt scene, as a row of read/pbrt/kinds.h, without those that all cameras share.
    const char* parameters = nullptr;
    /// Reads these parameters. Throws SceneError. Null: nothing to read.
    void (*read)(const pbrt::CameraReading&, CameraDescription&) = nullptr;
    /// Fills in the fields that the kind's kernel file reads; transform, motion, shutter and lens are already set. May throw SceneError.
    void (*pack)(const CameraPacking&, const CameraDescription&, camera&) = nullptr;
    /// Projects a point of camera space to the screen space of the packed camera. Nothing if the camera does not see it.
    std::optional<glm::dvec2> (*project)(const PackedScene&, glm::dvec3 p) = nullptr;
    /// pbrt-v4's projection of camera space to screen space, for the attribute worldToNDC of an EXR: the shorter side of the image spans
    /// [-1, 1] in x or y, the depths at which it clips [0, 1] in z. Null: the camera has none.
    glm::dmat4 (*screenFromCamera)(const CameraDescription&) = nullptr;
    /// Whether the right edge of the image continues at the left edge. Null: never.
    bool (*wrapsAround)(const camera&) = nullptr;
    /// Whether `lensRadius`, `frameAspectRatio` and `screenWindow` apply.
    bool hasThinLens = false;
    /// Whether rays pass through points of a lens whose size is not `lensRadius`.
    bool hasLensSystem = false;
    /// Its name in pbrt-v3. Null: the same name.
    const char* version3Name = nullptr;
};

/* One for each kind, defined in the kind's file. */
#define DECLARE_KIND(name, FEATURE, CODE, RAYS) extern const CameraTraits name##_camera;
CAMERAS(DECLARE_KIND)
#undef DECLARE_KIND

enum class CameraRays { CENTRAL, PARALLEL, AROUND, TRACED };   ///< as in CAMERAS

/// A line of CAMERAS.
struct CameraKind {
    const char* name;
    camera_kind value;
    Feature feature;
    CameraRays rays;
    const CameraTraits& traits;
};

/// All kinds, indexed by camera_kind.
std::span<const CameraKind> cameraKindList();
inline const CameraKind& kindOf(camera_kind kind) { return cameraKindList()[kind]; }
inline const CameraKind& kindOf(const camera& view) { return cameraKindList()[view.kind]; }
inline const CameraKind& kindOf(const CameraDescription& c) { return c.kind ? *c.kind : kindOf(camera_perspective); }

}  // namespace eikonal
