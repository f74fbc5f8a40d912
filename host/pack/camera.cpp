// The camera, the film's pixels and the pixel filter.

#include "pack/alias_table.h"
#include "pack/lens.h"
#include "pack/motion.h"
#include "pack/packer.h"

#include <cmath>

namespace eikonal {

/// pbrt-v4's rules: --pixelbounds and cropwindow select pixels of the whole image.
static PixelRect renderedPixels(const FilmDescription& film, Diagnostics& diagnostics) {
    PixelRect rect{0, 0, film.width, film.height};
    if (film.cropWindow) {
        const auto& c = *film.cropWindow;
        rect = {static_cast<int>(std::ceil(film.width * c[0])), static_cast<int>(std::ceil(film.height * c[2])),
                static_cast<int>(std::ceil(film.width * c[1])), static_cast<int>(std::ceil(film.height * c[3]))};
    }
    if (film.pixelBounds) rect = {film.pixelBounds->x0, film.pixelBounds->y0, film.pixelBounds->x1, film.pixelBounds->y1};
    const PixelRect clipped{std::max(rect.x0, 0), std::max(rect.y0, 0), std::min(rect.x1, film.width), std::min(rect.y1, film.height)};
    if (clipped.width() <= 0 || clipped.height() <= 0)
        throw SceneError(film.where, "the crop leaves no pixel of the " + std::to_string(film.width) + " x " + std::to_string(film.height) +
                                         " image. Ask for a window with x0 < x1 and y0 < y1 inside of it.");
    if (clipped.x0 != rect.x0 || clipped.y0 != rect.y0 || clipped.x1 != rect.x1 || clipped.y1 != rect.y1)
        diagnostics.warn(film.where, "the crop reaches beyond the image and was cut to it");
    return clipped;
}

/// A realistic camera's lens and film.
static void packLens(Packer& packer, const CameraDescription& description, camera& view) {
    const FilmDescription& film = packer.scene.film;
    SceneTables& tables = packer.packed.tables;
    packer.packed.require(Feature::IMPORTANCE, description.where.toString());
    const LensSystem lens(description, film.diagonal);
    if (lens.stopIsTooWide())
        packer.diagnostics.warn(description.where, "the aperture is wider than the lens's stop can be; it is as wide as that");
    tables.lens_elements = lens.elements();
    tables.pupils = lens.pupils();
    view.element_count = static_cast<uint>(tables.lens_elements.size());
    view.rear_z = static_cast<float>(lens.rearZ());
    view.film_radius = static_cast<float>(film.diagonal / 2000);

    const bool hasImage = description.aperture == ApertureShape::image;
    const ApertureTexels aperture = apertureTexels(description.aperture, hasImage ? packer.images[static_cast<size_t>(description.apertureImage)].get() : nullptr);
    if (!aperture.values.empty()) packer.packed.require(Feature::APERTURE, description.where.toString());
    tables.aperture_texels = aperture.values;
    view.aperture_width = static_cast<uint>(aperture.width);
    view.aperture_height = static_cast<uint>(aperture.height);

    /* The image is upside down and mirrored on the film: pixel (0, 0) lies at positive x, negative y */
    const double width = film.diagonal / 1000 / std::hypot(1.0, static_cast<double>(film.height) / film.width), pixel = width / film.width;
    view.screen_x = static_cast<float>(width / 2);
    view.screen_y = static_cast<float>(-pixel * film.height / 2);
    view.step_x = static_cast<float>(-pixel);
    view.step_y = static_cast<float>(pixel);
}

/// Screen coordinates of perspective and orthographic cameras: as wide as the image's shape makes it, the shorter side from -1 to 1.
static void packScreen(const CameraDescription& description, const FilmDescription& film, camera& view) {
    const double aspect = description.frameAspectRatio.value_or(static_cast<double>(film.width) / film.height);
    std::array<double, 4> window = aspect > 1 ? std::array<double, 4>{-aspect, aspect, -1, 1} : std::array<double, 4>{-1, 1, -1 / aspect, 1 / aspect};
    if (description.screenWindow) window = *description.screenWindow;
    const double reach = description.kind == CameraKind::perspective ? std::tan(glm::radians(description.fov) / 2) : 1;
    view.screen_x = static_cast<float>(window[0] * reach);
    view.screen_y = static_cast<float>(window[3] * reach);
    view.step_x = static_cast<float>((window[1] - window[0]) * reach / film.width);
    view.step_y = static_cast<float>((window[2] - window[3]) * reach / film.height);
}

/// A camera of the scene, and what it is on the device.
static std::pair<camera_kind, Feature> kindOf(CameraKind kind) {
    switch (kind) {
        case CameraKind::orthographic: return {camera_orthographic, Feature::CAMERA_ORTHOGRAPHIC};
        case CameraKind::spherical: return {camera_spherical, Feature::CAMERA_SPHERICAL};
        case CameraKind::realistic: return {camera_realistic, Feature::CAMERA_REALISTIC};
        case CameraKind::perspective: break;
    }
    return {camera_perspective, Feature::CAMERA_PERSPECTIVE};
}

static void packView(Packer& packer) {
    const CameraDescription& description = packer.scene.camera;
    const FilmDescription& film = packer.scene.film;
    settings& frame = packer.packed.frame();
    frame.width = static_cast<uint>(film.width);
    frame.height = static_cast<uint>(film.height);

    camera& view = frame.view;
    const auto [kind, feature] = kindOf(description.kind);
    view.kind = kind;
    packer.packed.require(feature, description.where.toString());
    if (kind == camera_realistic) packLens(packer, description, view);
    else if (kind == camera_spherical) {
        view.step_x = 1 / static_cast<float>(film.width);
        view.step_y = 1 / static_cast<float>(film.height);
        view.equal_area = description.equalArea;
    } else packScreen(description, film, view);

    view.scene_from_camera = toAffine(packer.space.sceneFromWorld() * description.worldFromCamera);
    view.times = shutterOf(packer.scene);
    const Motion way(description.worldFromCamera, description.worldFromCameraAtEnd.value_or(description.worldFromCamera));
    const TimeSpan seen = timesSeen(packer.scene);
    const auto cameraFromScene = [&](double time) { return glm::inverse(packer.space.sceneFromWorld() * way.at(time)); };
    packer.packed.cameraFromScene = {cameraFromScene(seen.from), cameraFromScene((seen.from + seen.to) / 2), cameraFromScene(seen.to)};
    if (description.worldFromCameraAtEnd) {
        packer.packed.require(Feature::CAMERA_MOTION, description.where.toString());
        view.moving = way.pack(packer.space, {});
    }
    view.lens_radius = static_cast<float>(description.lensRadius);
    view.focal_distance = static_cast<float>(description.focalDistance);
    view.medium = description.medium == none ? NONE : static_cast<uint>(description.medium);
    if (description.lensRadius > 0 && (kind == camera_perspective || kind == camera_orthographic)) packer.packed.require(Feature::LENS, description.where.toString());
}

/// The value of one axis of a filter at x pixels from the centre.
static double filterValue(const FilterDescription& f, double x, double radius) {
    x = std::abs(x);
    if (x >= radius) return 0;
    const auto gaussian = [&](double d) { return std::exp(-d * d / (2 * f.sigma * f.sigma)); };
    const auto sinc = [](double t) { return std::abs(t) < 1e-5 ? 1 : std::sin(M_PI * t) / (M_PI * t); };
    switch (f.kind) {
        case FilterKind::box: return 1;
        case FilterKind::triangle: return radius - x;
        case FilterKind::gaussian: return std::max(0.0, gaussian(x) - gaussian(radius));
        case FilterKind::mitchell: {
            /* Mitchell and Netravali 1988; its own support is [-2, 2] */
            const double t = 2 * x / radius, B = f.B, C = f.C;
            if (t <= 1) return ((12 - 9 * B - 6 * C) * t * t * t + (-18 + 12 * B + 6 * C) * t * t + (6 - 2 * B)) / 6;
            return ((-B - 6 * C) * t * t * t + (6 * B + 30 * C) * t * t + (-12 * B - 48 * C) * t + (8 * B + 24 * C)) / 6;
        }
        case FilterKind::sinc: return sinc(x) * sinc(x / f.tau);
    }
    return 0;
}

/// One axis as an alias table over cells of |f|; what is left of value over density is the sign.
static void packFilterAxis(Packer& packer, double radius) {
    std::vector<double> weights;
    for (int i = 0; i < FILTER_CELLS; ++i) {
        /* The mean of a few points stands for the cell */
        double mean = 0;
        constexpr int points = 8;
        for (int k = 0; k < points; ++k) mean += filterValue(packer.scene.filter, ((i + (k + 0.5) / points) * 2 / FILTER_CELLS - 1) * radius, radius) / points;
        weights.push_back(std::abs(mean));
        packer.packed.tables.filter_values.push_back(mean < 0 ? -1.0f : 1.0f);
    }
    const auto aliases = makeAliasTable(weights);
    packer.packed.tables.filter_aliases.insert(packer.packed.tables.filter_aliases.end(), aliases.begin(), aliases.end());
}

static void packFilter(Packer& packer) {
    const FilterDescription& description = packer.scene.filter;
    packer.packed.frame().pixel_filter = {static_cast<float>(description.xRadius), static_cast<float>(description.yRadius)};
    if (description.kind == FilterKind::box && description.xRadius == 0.5 && description.yRadius == 0.5) return;
    packer.packed.require(Feature::FILTER, description.where.toString());
    packFilterAxis(packer, description.xRadius);
    packFilterAxis(packer, description.yRadius);
}

void packCamera(Packer& packer) {
    packer.packed.pixels = renderedPixels(packer.scene.film, packer.diagnostics);
    packView(packer);
    packFilter(packer);
}

}  // namespace eikonal
