// Fills in the scene's camera from the parameters of a Camera directive.

#include "kinds/camera_packing.h"
#include "read/pbrt/settings.h"

#include <fmt/format.h>

namespace eikonal::pbrt {

void Settings::applyCamera(const Arguments& arguments) {
    CameraDescription& camera = reading_.scene.camera;
    camera.where = arguments.where();
    camera.kind = &kindOf(static_cast<camera_kind>(arguments.kind().value));
    if (camera.kind->traits.read) camera.kind->traits.read({reading_, arguments}, camera);
    if (camera.kind->traits.hasThinLens) applyScreen(arguments);
    camera.shutterOpen = arguments.number("shutteropen");
    camera.shutterClose = arguments.number("shutterclose");
    if (camera.shutterClose == camera.shutterOpen)
        throw SceneError(arguments.where(), fmt::format("the shutter closes when it opens, at {:g}: no light reaches the film; make "
                                                        "shutterclose larger than shutteropen", camera.shutterOpen));
    if (camera.shutterClose < camera.shutterOpen) {
        reading_.diagnostics.warn(arguments.where(), fmt::format("the shutter closes at {:g}, before it opens at {:g}; the two are swapped",
                                                                 camera.shutterClose, camera.shutterOpen));
        std::swap(camera.shutterOpen, camera.shutterClose);
    }
}

void Settings::applyScreen(const Arguments& arguments) {
    CameraDescription& camera = reading_.scene.camera;
    if (arguments.has("frameaspectratio")) camera.frameAspectRatio = arguments.number("frameaspectratio");
    if (arguments.has("screenwindow")) {
        const std::vector<double> window = arguments.numbers("screenwindow");
        expectCount(arguments, "screenwindow", window, 4);
        if (window[0] == window[1] || window[2] == window[3])
            throw SceneError(
                arguments.whereOf("screenwindow"),
                "\"float screenwindow\" is empty: its values are x0 x1 y0 y1, with different x0 and x1, and different y0 and y1");
        camera.screenWindow = {window[0], window[1], window[2], window[3]};
    }
    camera.lensRadius = arguments.number("lensradius");
    camera.focalDistance = arguments.number("focaldistance");
    if (camera.lensRadius > 0 && !(camera.focalDistance > 0))
        throw SceneError(arguments.whereOf("focaldistance"),
                         fmt::format("{}: \"float focaldistance\" is {:g}; with a lens it must be in (0, inf)", arguments.kind().title(),
                                     camera.focalDistance));
}

}  // namespace eikonal::pbrt
