#pragma once
// The camera of a scene.

#include "error.h"
#include "scene/basics.h"

#include <array>
#include <optional>
#include <vector>

namespace eikonal {

enum class CameraKind { perspective, orthographic, spherical, realistic };

/// One interface of a lens, in order from the scene to the film; lengths in millimetres.
struct LensElement {
    double curvatureRadius = 0;   ///< > 0: convex towards the scene; 0: the aperture stop
    double thickness = 0;         ///< distance to the next element; of the last one, to the film before focusing
    double eta = 1;               ///< index of refraction behind it; 0 means 1
    double apertureDiameter = 0;
};

enum class ApertureShape { round, gaussian, square, pentagon, star, image };

struct CameraDescription {
    CameraKind kind = CameraKind::perspective;
    Transform worldFromCamera{1};                        ///< camera space: x right, y up, looking along +z
    double fov = 90;                                     ///< degrees, along the shorter side of the image
    std::optional<double> frameAspectRatio;
    std::optional<std::array<double, 4>> screenWindow;   ///< x0 x1 y0 y1
    std::optional<Transform> worldFromCameraAtEnd;       ///< set: the camera moves, and has this transform at Scene::motionEnd
    double lensRadius = 0, focalDistance = 1e6;
    bool equalArea = true;                               ///< spherical: mapping of directions; false: longitude and latitude
    std::vector<LensElement> lens;                       ///< realistic
    double apertureDiameter = 1;                         ///< realistic: diameter of the stop, millimetres
    double focusDistance = 10;                           ///< realistic: in camera space, metres
    ApertureShape aperture = ApertureShape::round;       ///< realistic
    int apertureImage = none;                            ///< realistic: index in Scene::images
    double shutterOpen = 0, shutterClose = 1;
    int medium = none;                                   ///< the medium around the camera, in Scene::media
    SourceLocation where;
};

}  // namespace eikonal
