// The camera, the film's pixels and the pixel filter.

#include "kinds/filter_kind.h"
#include "kinds/camera_kind.h"
#include "pack/alias_table.h"
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

static void packView(Packer& packer) {
    const CameraDescription& description = packer.scene.camera;
    const FilmDescription& film = packer.scene.film;
    settings& frame = packer.packed.frame();
    frame.width = static_cast<uint>(film.width);
    frame.height = static_cast<uint>(film.height);

    camera& view = frame.view;
    const CameraKind& kind = kindOf(description);
    view.kind = kind.value;
    packer.packed.require(kind.feature, description.where.toString());
    kind.traits.pack(packer, description, view);

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
    if (description.lensRadius > 0 && kind.traits.hasThinLens) packer.packed.require(Feature::LENS, description.where.toString());
}

/// One axis as an alias table over cells of |f|; what is left of value over density is the sign.
static void packFilterAxis(Packer& packer, double radius) {
    const FilterDescription& filter = packer.scene.filter;
    std::vector<double> weights;
    for (int i = 0; i < FILTER_CELLS; ++i) {
        /* The mean of a few points stands for the cell */
        double mean = 0;
        constexpr int points = 8;
        for (int k = 0; k < points; ++k)
            mean += filter.kind->eval(filter, std::abs(((i + (k + 0.5) / points) * 2 / FILTER_CELLS - 1) * radius), radius) / points;
        weights.push_back(std::abs(mean));
        packer.packed.tables.filter_values.push_back(mean < 0 ? -1.0f : 1.0f);
    }
    const auto aliases = makeAliasTable(weights);
    packer.packed.tables.filter_aliases.insert(packer.packed.tables.filter_aliases.end(), aliases.begin(), aliases.end());
}

static void packFilter(Packer& packer) {
    const FilterDescription& description = packer.scene.filter;
    packer.packed.frame().pixel_filter = {static_cast<float>(description.xRadius), static_cast<float>(description.yRadius)};
    if (description.kind == &box_filter && description.xRadius == 0.5 && description.yRadius == 0.5) return;
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
