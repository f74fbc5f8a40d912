#pragma once
// Reads a Wavefront OBJ file as a scene. For users: docs/obj.md.

#include "diagnostics.h"
#include "read/formats/loose_files.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>

namespace eikonal {

/// Options of the user (--camera --look-at --up --fov --resolution). World units, degrees, pixels.
struct ObjOptions {
    std::optional<glm::dvec3> camera, lookAt;  ///< position of the camera, and a point at the centre of the image
    glm::dvec3 up{0, 1, 0};                    ///< not zero, not parallel to the view
    std::optional<double> fov;                 ///< along the shorter side of the image, in (0, 180)
    std::optional<int> width, height;          ///< positive
    std::optional<double> turns;               ///< how far the camera has gone round the model; unset: it is to stay
    MissingFiles missingFiles = MissingFiles::error;
};

/// Reads an OBJ file, possibly gzip-compressed, and its material libraries. Makes one shape for each material of each object, with
/// materials as described in docs/obj.md. Surfaces with Ke emit, on both sides unless their mesh is closed. chooseView (view.h) places the
/// camera; if nothing emits, a sky is added (sky.h). Throws SceneError for a malformed file, UsageError for impossible options, and one
/// Error that lists all missing images. Warns of missing libraries and materials (their faces are grey), of unsupported features, and of
/// faces without area.
Scene readObj(const std::string& path, const ObjOptions& options, Diagnostics& diagnostics);

}  // namespace eikonal
