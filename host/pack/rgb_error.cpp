#include "pack/rgb_error.h"

#include "color/luminance.h"
#include "kinds/light_kind.h"
#include "pack/medium_colors.h"
#include "pack/scene_colors.h"
#include "pack/scene_extent.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eikonal {
namespace {

/// Parts of the image, and of its light, that are smaller than this do not count by themselves.
constexpr double leastSight = 0.002, leastLight = 0.15, leastTexels = 0.04;
/// The part of a surface's surroundings that is other surfaces: of a room, and under a sky.
constexpr double closed = 0.85, open = 0.35;
/// A channel darker than this part of the brightest is compared with this part.
constexpr double darkest = 0.02;

constexpr double pi = std::numbers::pi;

/// The channel that is most off, relative to the colour of the spectrum.
double errorOf(const DualColor& light) {
    const glm::dvec3 seen = light.seen(), difference = glm::abs(light.rgb - seen);
    const double least = darkest * std::max({seen.x, seen.y, seen.z});
    double worst = 0;
    for (int c = 0; c < 3; ++c) worst = std::max(worst, difference[c] / std::max({seen[c], least, 1e-30}));
    return worst;
}

DualColor ofUnitLuminance(const DualColor& light) {
    const double Y = luminance(light.seen());
    return Y > 0 ? light * (1 / Y) : DualColor{};
}

class Prediction {
public:
    Prediction(const Scene& scene, const std::vector<std::shared_ptr<const ImageData>>& images, const Box& near)
        : scene_(scene), colors_(scene, images), extents_(extentsOf(scene, near)) {}

    RgbError make() {
        collectLights();
        collectSurfaces();
        addSurfaces();
        addMedia();
        if (luminance(image_.seen()) > 0) result_.mean = errorOf(image_);
        return result_;
    }

private:
    struct Source {
        ColorSet colors;
        double irradiance = 0;
        bool isImage = false;
    };
    struct Surface {
        int material = none;
        const ColorSet* colors = nullptr;
        double sight = 0;
    };

    /// Irradiance somewhere in the scene, roughly.
    double irradianceOf(const Light& light, double luminance) const {
        const double lamp = 4 * pi * (light.power ? *light.power / (4 * pi) : luminance) / (pi * extents_.radius * extents_.radius);
        switch (light.kind->place) {
            case LightPlace::INFINITE:
                return pi * luminance;
            case LightPlace::DISTANT:
                return luminance;
            default:
                return lamp;
        }
    }

    void collectLights() {
        std::vector<Source> sources;
        const auto add = [&](ColorSet colors, const auto& irradiance, bool isImage) {
            const double Y = luminance(meanOf(colors).seen());
            if (Y > 0) sources.push_back({std::move(colors), irradiance(Y), isImage});
        };
        for (const Light& light : scene_.lights) {
            isOpen_ |= light.kind->place == LightPlace::INFINITE || light.kind->place == LightPlace::DISTANT;
            add(
                colors_.ofLight(light), [&](double Y) { return irradianceOf(light, Y); }, light.image != none);
        }
        for (size_t i = 0; i < scene_.areaLights.size(); ++i) {
            const AreaLight& light = scene_.areaLights[i];
            const double area = extents_.areaLights[static_cast<int>(i)].area;
            add(
                colors_.ofLight(light),
                [&](double Y) { return (light.power ? *light.power : pi * Y * area) / (pi * extents_.radius * extents_.radius); }, false);
        }
        double sum = 0;
        for (const Source& s : sources) sum += s.irradiance;
        for (const Source& s : sources) {
            const double share = s.irradiance / std::max(sum, 1e-300);
            const DualColor mean = ofUnitLuminance(meanOf(s.colors));
            light_ = light_ + mean * share;
            if (share >= leastLight) lights_.push_back(mean);
            for (const SharedColor& part : s.colors)
                if (s.isImage && share * part.share >= leastTexels) lights_.push_back(ofUnitLuminance(part.color));
        }
        lights_.push_back(light_);
    }

    void collectSurfaces() {
        for (const auto& [material, extent] : extents_.materials) {
            const ColorSet& colors = colors_.ofMaterial(material);
            if (colors.empty()) continue;  // clear
            surfaces_.push_back({material, &colors, extent.sight});
            sight_ += extent.sight;
            around_ = around_ + meanOf(colors) * extent.sight;
        }
        around_ = around_ * (1 / std::max(sight_, 1e-300));
    }

    /// Light that other surfaces reflect to this one. Under a sky, most surfaces are convex and see little of themselves.
    DualColor indirect(const Surface& surface) const {
        const double own = surface.sight / std::max(sight_, 1e-300);
        const DualColor around = isOpen_ ? around_ + meanOf(*surface.colors) * -own : around_;
        const double enclosure = isOpen_ ? open : closed;
        return light_ * around.map([=](double a) {
            const double part = enclosure * std::clamp(a, 0.0, 1.0);
            return part / (1 - part);
        });
    }

    void addSurfaces() {
        for (const Surface& surface : surfaces_) {
            const double share = surface.sight / std::max(sight_, 1e-300);
            const DualColor reflected = indirect(surface);
            for (const SharedColor& part : *surface.colors) {
                image_ = image_ + part.color * (light_ + reflected) * (share * part.share);
                if (share * part.share < leastSight) continue;
                for (const DualColor& light : lights_)
                    consider(part.color * (light + reflected), [&] { return causeOf(surface.material); });
            }
        }
    }

    /// Behind media are surfaces, or the sky.
    void addMedia() {
        const DualColor background = isOpen_ || surfaces_.empty() ? (around_ + DualColor::constant(1)) * 0.5 : around_;
        for (const auto& [index, extent] : extents_.media) {
            const Medium& medium = scene_.media[static_cast<size_t>(index)];
            for (const MediumColor& m : colorsOf(medium))
                for (const double path : {0.5, 1.0, 2.0})
                    for (const DualColor& light : lights_)
                        consider(light * m.seen(background, path * extent.chord),
                                 [&] { return medium.where.toString() + ": medium \"" + medium.name + "\""; });
        }
    }

    std::string causeOf(int material) const {
        if (material == none) return "surfaces without a material";
        const Material& m = scene_.materials[static_cast<size_t>(material)];
        return m.where.toString() + ": material" + (m.name.empty() ? "" : " \"" + m.name + "\"");
    }

    template <class Cause>
    void consider(const DualColor& light, const Cause& cause) {
        const double error = errorOf(light);
        if (error <= result_.worst) return;
        result_.worst = error;
        result_.cause = cause();
    }

    const Scene& scene_;
    SceneColors colors_;
    SceneExtents extents_;
    RgbError result_;
    bool isOpen_ = false;
    std::vector<Surface> surfaces_;
    std::vector<DualColor> lights_;  ///< that light some parts of the image alone, and all together; of luminance 1
    DualColor light_;                ///< all together, of luminance 1
    double sight_ = 0;
    DualColor around_;  ///< the mean of what surfaces reflect
    DualColor image_;
};

}  // namespace

RgbError predictRgbError(const Scene& scene, const std::vector<std::shared_ptr<const ImageData>>& images, const Box& near) {
    return Prediction(scene, images, near).make();
}

}  // namespace eikonal
