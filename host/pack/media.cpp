#include "pack/media.h"

#include "kinds/light_kind.h"
#include "kinds/medium_packing.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace eikonal {

void MediumPacker::pack() {
    if (!context_.hasMedia) return;
    for (const Medium& description : context_.scene.media) {
        const std::string what = description.where.toString() + ": medium \"" + description.name + "\"";
        context_.require(description.kind->feature, what);
        context_.require(Feature::MEDIA, what);
        tables_.media.push_back(description.kind->traits.pack({context_, tables_, colors_}, description));
    }
}

uint MediumPacker::interior(const std::shared_ptr<const Medium>& interior, const std::string& why) {
    Table<medium>& media = tables_.media;
    const auto [place, isNew] = interiors_.try_emplace(interior.get(), static_cast<uint>(media.size()));
    if (isNew) {
        for (Feature feature : {Feature::SUBSURFACE, Feature::MEDIA, interior->kind->feature}) context_.require(feature, why);
        media.push_back(interior->kind->traits.pack({context_, tables_, colors_}, *interior));
        if (media.size() > NO_BODY_MEDIUM)
            throw SceneError(interior->where, fmt::format("the scene has more than {} media and bodies of material \"subsurface\" that "
                                                          "random walks enter; \"string method\" \"diffusion\" has no such limit",
                                                          NO_BODY_MEDIUM));
    }
    return place->second;
}

void MediumPacker::packEquiangularLights(const Table<light>& lights) {
    /* Light paths arrive near lights by themselves */
    if (context_.has(Feature::LIGHT_PATHS)) return;
    std::vector<std::pair<float, vec3>> points;
    for (const light& l : lights)
        if (kindOf(l).place == LightPlace::POINT) points.emplace_back(colors_.greatestSum(&l.L, nullptr), l.p);
    std::ranges::stable_sort(points, [](const auto& a, const auto& b) { return a.first > b.first; });
    points.resize(std::min(points.size(), size_t{MOST_EQUIANGULAR_LIGHTS}));
    float sum = 0;
    for (const auto& [intensity, p] : points) sum += intensity;
    if (!(sum > 0)) return;
    /* The media of the scene come first; interiors of bodies are lit through their surface */
    const size_t open = context_.hasMedia ? context_.scene.media.size() : 0;
    for (medium& m : std::span(tables_.media).first(open)) {
        if (kindOf(m).variation != MediumVariation::HOMOGENEOUS || colors_.greatestSum(&m.sigma_s, nullptr) <= 0) continue;
        m.equiangular_lights = static_cast<uint>(points.size());
        context_.require(Feature::EQUIANGULAR, "the scene has a point light and a medium that scatters");
    }
    if (!context_.has(Feature::EQUIANGULAR)) return;
    for (const auto& [intensity, p] : points) tables_.point_lights.push_back({p, intensity / sum});
}

}  // namespace eikonal
