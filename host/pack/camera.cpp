#include "pack/camera.h"

#include "kinds/camera_kind.h"
#include "kinds/filter_kind.h"
#include "pack/alias_table.h"
#include "pack/motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace eikonal {

PixelRect renderedPixels(const FilmDescription& film, Diagnostics& diagnostics) {
    PixelRect rect{0, 0, film.width, film.height};
    const SourceLocation& where = film.cropPlace.file ? film.cropPlace : film.where;
    if (film.cropWindow) {
        const auto& c = *film.cropWindow;
        /* In single precision, as in pbrt-v4: 0.55 of 100 columns are 55, not 56 */
        const auto part = [](int size, double share) {
            return static_cast<int>(std::ceil(static_cast<float>(size) * static_cast<float>(share)));
        };
        rect = {part(film.width, c[0]), part(film.height, c[2]), part(film.width, c[1]), part(film.height, c[3])};
    }
    if (film.pixelBounds) rect = {film.pixelBounds->x0, film.pixelBounds->y0, film.pixelBounds->x1, film.pixelBounds->y1};
    const PixelRect clipped{std::max(rect.x0, 0), std::max(rect.y0, 0), std::min(rect.x1, film.width), std::min(rect.y1, film.height)};
    const std::string crop = fmt::format("the crop, x from {} to {} and y from {} to {},", rect.x0, rect.x1, rect.y0, rect.y1),
                      image = fmt::format(" {} x {} image", film.width, film.height);
    if (clipped.width() <= 0 || clipped.height() <= 0)
        throw SceneError(where, crop + " leaves no pixel of the" + image + "; use a window with x0 < x1 and y0 < y1 inside the image");
    if (clipped.x0 != rect.x0 || clipped.y0 != rect.y0 || clipped.x1 != rect.x1 || clipped.y1 != rect.y1)
        diagnostics.warn(where, crop + " extends beyond the" + image + "; it is clipped");
    return clipped;
}

double cameraUnit(const PackContext& context) {
    const double length = context.space.scale * glm::length(transformVector(context.scene.camera.worldFromCamera, {0, 0, 1}));
    return length > 0 && std::isfinite(length) ? std::ldexp(1.0, -std::ilogb(length)) : 1;
}

/// The motion of the camera in world space, from a camera space of that unit.
static Motion motionOf(const CameraDescription& description, double unit) {
    return {description.worldFromCamera * scaling(unit),
            description.worldFromCameraAtEnd.value_or(description.worldFromCamera) * scaling(unit)};
}

void packCamera(const CameraPacking& in, camera& view) {
    const PackContext& context = in.context;
    const CameraDescription& description = context.scene.camera;
    const CameraKind& kind = kindOf(description);
    view.kind = kind.value;
    view.is_parallel = kind.rays == CameraRays::PARALLEL;
    view.is_around = kind.rays == CameraRays::AROUND;
    context.require(kind.feature, description.where.toString());
    view.scene_from_camera = toAffine(context.space.sceneFromWorld() * description.worldFromCamera * scaling(in.unit));
    view.times = shutterOf(context.scene);
    if (description.worldFromCameraAtEnd) {
        context.require(Feature::CAMERA_MOTION, description.where.toString());
        view.moving = motionOf(description, in.unit).pack(context.space, {});
    }
    view.lens_radius = static_cast<float>(description.lensRadius / in.unit);
    view.focal_distance = static_cast<float>(description.focalDistance / in.unit);
    view.medium = context.hasMedia && description.medium != none ? static_cast<uint>(description.medium) : NONE;
    if (description.lensRadius > 0 && kind.traits.hasThinLens) context.require(Feature::LENS, description.where.toString());
    kind.traits.pack(in, description, view);
}

/// A filter is as fine as in pbrt-v4.
constexpr double cellsPerPixel = 16;

/// One axis as an alias table over cells of |f|; value over density is then the sign. Returns its mean.
static double packFilterAxis(CameraTables& tables, const FilterDescription& filter, double radius, uint cells) {
    std::vector<double> weights;
    double sum = 0, size = 0;
    for (uint i = 0; i < cells; ++i) {
        /* Average a few points of the cell */
        double mean = 0;
        constexpr int points = 8;
        for (int k = 0; k < points; ++k)
            mean += filter.kind->eval(filter, std::abs(((i + (k + 0.5) / points) * 2 / cells - 1) * radius), radius) / points;
        weights.push_back(std::abs(mean));
        sum += mean;
        size += std::abs(mean);
        tables.filter_values.push_back(mean < 0 ? -1.0f : 1.0f);
    }
    const auto aliases = makeAliasTable(weights);
    tables.filter_aliases.insert(tables.filter_aliases.end(), aliases.begin(), aliases.end());
    return sum / size;
}

void packFilter(const CameraPacking& in, filter& packed) {
    const FilterDescription& description = in.context.scene.filter;
    const double cells = std::clamp(cellsPerPixel * 2 * std::max(description.xRadius, description.yRadius), 64., double{MOST_FILTER_CELLS});
    packed = {static_cast<float>(description.xRadius), static_cast<float>(description.yRadius), std::bit_ceil(static_cast<uint>(cells)), 1};
    if (description.kind == &box_filter && description.xRadius == 0.5 && description.yRadius == 0.5) return;
    in.context.require(Feature::FILTER, description.where.toString());
    const double x = packFilterAxis(in.tables, description, description.xRadius, packed.cells),
                 y = packFilterAxis(in.tables, description, description.yRadius, packed.cells);
    packed.mean = static_cast<float>(x * y);
}

std::array<glm::dmat4, 3> cameraFromScene(const PackContext& context) {
    const Motion way = motionOf(context.scene.camera, 1);
    const TimeSpan seen = timesSeen(context.scene);
    const auto at = [&](double time) { return glm::inverse(context.space.sceneFromWorld() * way.at(time)); };
    return {at(seen.from), at((seen.from + seen.to) / 2), at(seen.to)};
}

}  // namespace eikonal
