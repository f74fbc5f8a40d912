#pragma once
// What the host knows of each kind of camera: one file of host/kinds/camera/ for each line of CAMERAS (include/eikonal/cameras.h).

#include "eikonal/cameras.h"
#include "feature_set.h"
#include "scene/camera.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>

namespace eikonal {

struct PackedScene;
struct Packer;
namespace pbrt { struct CameraReading; }

/// What a kind's file defines. All but `read` and `wrapsAround` must be there (tests/unit/kinds_test.cpp).
struct CameraTraits {
    /// Of `Camera "name"` in a pbrt scene: its parameters, as a row of read/pbrt/kinds.h, besides those that all cameras have.
    const char* parameters = nullptr;
    /// Reads them. Throws SceneError. Null: it has none.
    void (*read)(const pbrt::CameraReading&, CameraDescription&) = nullptr;
    /// Fills in what the kind's kernel file reads; place, motion, shutter and thin lens are there already. May throw SceneError.
    void (*pack)(Packer&, const CameraDescription&, camera&) = nullptr;
    /// Where the camera sees a point of camera space: in the screen space of the packed camera. Nothing: it does not see it.
    std::optional<glm::dvec2> (*project)(const PackedScene&, glm::dvec3 p) = nullptr;
    /// Whether the right edge of its image meets the left edge. Null: never.
    bool (*wrapsAround)(const camera&) = nullptr;
    /// Whether it has a thin lens of `lensRadius`.
    bool hasThinLens = false;
    /// Its name in pbrt-v3, if it had another. Null: it had not.
    const char* version3Name = nullptr;
};

/* Each kind's file defines one of them. */
#define DECLARE_KIND(name, FEATURE, CODE) extern const CameraTraits name##_camera;
CAMERAS(DECLARE_KIND)
#undef DECLARE_KIND

/// A line of CAMERAS.
struct CameraKind {
    const char* name;
    camera_kind value;
    Feature feature;
    const CameraTraits& traits;
};

/// All kinds, by camera_kind.
std::span<const CameraKind> cameraKindList();
inline const CameraKind& kindOf(camera_kind kind) { return cameraKindList()[kind]; }
inline const CameraKind& kindOf(const camera& view) { return cameraKindList()[view.kind]; }
inline const CameraKind& kindOf(const CameraDescription& c) { return c.kind ? *c.kind : kindOf(camera_perspective); }

}  // namespace eikonal
