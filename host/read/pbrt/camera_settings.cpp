// Fills in the scene's camera from the parameters of a Camera directive.

#include "read/pbrt/lens_file.h"
#include "read/pbrt/settings.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal::pbrt {

void Settings::applyCamera(const Arguments& arguments) {
    CameraDescription& camera = reading_.scene.camera;
    camera.where = arguments.where();
    camera.kind = static_cast<CameraKind>(arguments.kind().value);
    if (camera.kind == CameraKind::perspective) camera.fov = arguments.number("fov");
    if (arguments.has("frameaspectratio")) camera.frameAspectRatio = arguments.number("frameaspectratio");
    if (arguments.has("screenwindow")) {
        const std::vector<double> window = arguments.numbers("screenwindow");
        expectCount(arguments, "screenwindow", window, 4);
        if (window[0] == window[1] || window[2] == window[3])
            throw SceneError(arguments.whereOf("screenwindow"), "\"float screenwindow\" is empty: its values are x0 x1 y0 y1, with different x0 and x1, and different y0 and y1");
        camera.screenWindow = {window[0], window[1], window[2], window[3]};
    }
    if (camera.kind == CameraKind::spherical) applyMapping(arguments);
    if (camera.kind == CameraKind::realistic) applyLens(arguments);
    camera.lensRadius = arguments.number("lensradius");
    camera.focalDistance = arguments.number("focaldistance");
    if (camera.lensRadius > 0 && !(camera.focalDistance > 0))
        throw SceneError(arguments.whereOf("focaldistance"), fmt::format("{}: \"float focaldistance\" is {:g}; with a lens it must be in (0, inf)",
                                                                         arguments.kind().title(), camera.focalDistance));
    camera.shutterOpen = arguments.number("shutteropen");
    camera.shutterClose = arguments.number("shutterclose");
    if (!(camera.shutterClose > camera.shutterOpen))
        throw SceneError(arguments.where(), "the shutter must close after it opens: shutteropen is " + std::to_string(camera.shutterOpen) +
                                                ", shutterclose " + std::to_string(camera.shutterClose));
}

void Settings::applyMapping(const Arguments& arguments) {
    const std::string mapping = arguments.text("mapping");
    if (mapping != "equalarea" && mapping != "equirectangular")
        throw SceneError(arguments.whereOf("mapping"), "there is no mapping \"" + mapping + "\"; it can be \"equalarea\" or \"equirectangular\"");
    reading_.scene.camera.equalArea = mapping == "equalarea";
}

void Settings::applyLens(const Arguments& arguments) {
    CameraDescription& camera = reading_.scene.camera;
    if (!arguments.has("lensfile")) throw SceneError(arguments.where(), "camera \"realistic\" needs a \"string lensfile\"");
    const std::optional<std::string> path = arguments.file("lensfile");
    if (path) camera.lens = readLensFile(*path);
    camera.apertureDiameter = arguments.number("aperturediameter");
    camera.focusDistance = arguments.number("focusdistance");

    const std::string aperture = arguments.text("aperture");
    constexpr std::pair<const char*, ApertureShape> shapes[] = {{"", ApertureShape::round}, {"gaussian", ApertureShape::gaussian},
        {"square", ApertureShape::square}, {"pentagon", ApertureShape::pentagon}, {"star", ApertureShape::star}};
    const auto shape = std::ranges::find(shapes, aperture, [](const auto& s) { return std::string(s.first); });
    if (shape != std::end(shapes)) { camera.aperture = shape->second; return; }
    const std::optional<std::string> image = reading_.findFile(aperture, arguments.whereOf("aperture"));
    if (!image) return;
    camera.aperture = ApertureShape::image;
    camera.apertureImage = static_cast<int>(reading_.scene.images.size());
    ImageFile file;
    file.path = *image;
    file.where = arguments.whereOf("aperture");
    reading_.scene.images.push_back(file);
}

}  // namespace eikonal::pbrt
