// Realistic camera: a system of lenses in front of a film (kernels/camera/realistic.clh).

#include "kinds/camera_packing.h"
#include "pack/lens.h"
#include "read/formats/image.h"
#include "read/pbrt/lens_file.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

static void read(const pbrt::CameraReading& in, CameraDescription& camera) {
    if (!in.arguments.has("lensfile")) throw SceneError(in.arguments.where(), "camera \"realistic\" needs a \"string lensfile\"");
    const std::optional<std::string> path = in.arguments.file("lensfile");
    if (path) camera.lens = pbrt::readLensFile(*path);
    camera.apertureDiameter = in.arguments.number("aperturediameter");
    camera.focusDistance = in.arguments.number("focusdistance");

    const std::string aperture = in.arguments.text("aperture");
    constexpr std::pair<const char*, ApertureShape> shapes[] = {{"", ApertureShape::round}, {"gaussian", ApertureShape::gaussian},
        {"square", ApertureShape::square}, {"pentagon", ApertureShape::pentagon}, {"star", ApertureShape::star}};
    const auto shape = std::ranges::find(shapes, aperture, [](const auto& s) { return std::string(s.first); });
    if (shape != std::end(shapes)) { camera.aperture = shape->second; return; }
    const std::optional<std::string> image = in.reading.findFile(aperture, in.arguments.whereOf("aperture"));
    if (!image) return;
    camera.aperture = ApertureShape::image;
    camera.apertureImage = addImage(in.reading.scene, {.path = *image, .where = in.arguments.whereOf("aperture")});
}

/// The tables of the lens, whose lengths are metres there and the camera's unit here.
static void packLens(const LensSystem& lens, const CameraPacking& in, camera& view) {
    const auto metre = static_cast<float>(1 / in.unit);
    in.tables.lens_elements = lens.elements();
    in.tables.pupils = lens.pupils();
    const LensDisk front = lens.front(in.tables.pupils);
    for (lens_element& e : in.tables.lens_elements)
        for (float* length : {&e.z, &e.radius, &e.aperture}) *length *= metre;
    for (pupil_bounds& b : in.tables.pupils)
        for (float* length : {&b.low_x, &b.low_y, &b.high_x, &b.high_y}) *length *= metre;
    view.element_count = static_cast<uint>(in.tables.lens_elements.size());
    view.rear_z = static_cast<float>(lens.rearZ() / in.unit);
    view.front_z = static_cast<float>(front.z / in.unit);
    view.lens_radius = static_cast<float>(front.radius / in.unit);
}

static void pack(const CameraPacking& in, const CameraDescription& description, camera& view) {
    const FilmDescription& film = in.context.scene.film;
    CameraTables& tables = in.tables;
    for (const Feature feature : {Feature::IMPORTANCE, Feature::LENS}) in.context.require(feature, description.where.toString());
    const LensSystem lens(description, film.diagonal);
    if (lens.stopIsTooWide())
        in.context.diagnostics.warn(description.where, "the aperture is larger than the lens's stop; it is clamped to the stop");
    packLens(lens, in, view);
    const double diagonal = film.diagonal / in.unit;
    view.film_radius = static_cast<float>(diagonal / 2000);

    const bool hasImage = description.aperture == ApertureShape::image;
    const ApertureTexels aperture =
        apertureTexels(description.aperture, hasImage ? &in.context.imageData(description.apertureImage) : nullptr);
    if (!aperture.values.empty()) in.context.require(Feature::APERTURE, description.where.toString());
    tables.aperture_texels = aperture.values;
    view.aperture_width = static_cast<uint>(aperture.width);
    view.aperture_height = static_cast<uint>(aperture.height);

    /* The image is upside down and mirrored on the film: pixel (0, 0) lies at positive x, negative y */
    const double width = diagonal / 1000 / std::hypot(1.0, static_cast<double>(film.height) / film.width), pixel = width / film.width;
    view.screen_x = static_cast<float>(width / 2);
    view.screen_y = static_cast<float>(-pixel * film.height / 2);
    view.step_x = static_cast<float>(-pixel);
    view.step_y = static_cast<float>(pixel);
}

/// The film point at which p is seen, by the chief ray (through the centre of the stop). Paraxial: heights and slopes are linear in the
/// film point (Pharr et al. 2016, section 6.4.1).
static std::optional<glm::dvec2> project(const PackedScene& scene, glm::dvec3 p) {
    struct Ray { double height, slope, z; };
    Ray film{1, 0, 0}, slope{0, 1, 0};   /* basis: height 1, slope 0 and height 0, slope 1 at the film */
    double across = 0;                   /* slope at the film of the chief ray from height 1 */
    double last = 0;
    for (const lens_element& e : scene.tables.lens_elements) {
        for (Ray* r : {&film, &slope}) {
            r->height += r->slope * (e.z - r->z);
            r->z = e.z;
            /* n' u' = n u - h (n' - n) / R, where R is -radius: the centre of a convex element lies on the side of the film */
            if (e.radius != 0) r->slope = (r->slope + r->height * (e.eta - 1) / e.radius) / e.eta;
        }
        if (e.radius == 0 && slope.height != 0) across = -film.height / slope.height;
        last = e.z;
    }
    const double magnification = film.height + across * slope.height + (film.slope + across * slope.slope) * (p.z - last);
    if (p.z <= last || magnification == 0) return std::nullopt;
    return glm::dvec2(p) / magnification;
}

const CameraTraits realistic_camera{
    .parameters = "file lensfile; float aperturediameter = 1 in (0, inf); float focusdistance = 10 in (0, inf); string aperture",
    .read = read,
    .pack = pack,
    .project = project,
    .hasLensSystem = true};

}  // namespace eikonal
