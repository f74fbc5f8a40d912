#pragma once
// A Wavefront OBJ file as a scene by itself. For users: docs/obj.md.

#include "diagnostics.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>

namespace eikonal {

/// What the user decides instead of the reader (--camera --look-at --up --fov --resolution). World units, degrees, pixels.
struct ObjOptions {
    std::optional<glm::dvec3> camera, lookAt;  ///< where the eye is, and a point in the middle of the image
    glm::dvec3 up{0, 1, 0};                    ///< not zero, not along the view
    std::optional<double> fov;                 ///< along the shorter side of the image, in (0, 180)
    std::optional<int> width, height;          ///< positive
};

/// Reads an OBJ file, compressed with gzip or not, and its material libraries. One shape for each material of each object; materials as in
/// docs/obj.md; surfaces with Ke emit, on both sides unless their mesh is closed. The camera is placed by chooseView (view.h). If nothing
/// emits, there is a sky (sky.h).
/// Throws SceneError for a malformed file, UsageError for impossible options, and one Error that lists all images that are missing.
/// Warns of missing libraries and materials (their faces are grey), of what is not rendered, and of faces without area.
Scene readObj(const std::string& path, const ObjOptions& options, Diagnostics& diagnostics);

}  // namespace eikonal
