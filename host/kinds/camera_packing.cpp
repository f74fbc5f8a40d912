#include "kinds/camera_packing.h"

namespace eikonal {

void packScreen(const PackContext& context, const CameraDescription& description, double reach, camera& view) {
    const FilmDescription& film = context.scene.film;
    const double aspect = description.frameAspectRatio.value_or(static_cast<double>(film.width) / film.height);
    std::array<double, 4> window =
        aspect > 1 ? std::array<double, 4>{-aspect, aspect, -1, 1} : std::array<double, 4>{-1, 1, -1 / aspect, 1 / aspect};
    if (description.screenWindow) window = *description.screenWindow;
    view.screen_x = static_cast<float>(window[0] * reach);
    view.screen_y = static_cast<float>(window[3] * reach);
    view.step_x = static_cast<float>((window[1] - window[0]) * reach / film.width);
    view.step_y = static_cast<float>((window[2] - window[3]) * reach / film.height);
}

}  // namespace eikonal
